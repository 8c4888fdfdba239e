"""Maps of 0 A.D.: a square of one as an imported scene."""

from __future__ import annotations

import math
import random
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from c4s.errors import BadInput
from c4s.records.pack import BoxBody, CollisionBody
from cases.importers.imported import ImportedScene, Matrix, SceneActor, SceneAsset, SceneLight
from cases.zeroad.actors import template_of
from cases.zeroad.archive import Archive
from cases.zeroad.ground import MapGround, Square
from cases.zeroad.pmp import read_pmp
from cases.zeroad.shapes import Shapes, cut_at_ground, turned
from cases.zeroad.things import ActorPiece, about_its_foot, split

ALIVE = ("units/", "actor|units/", "gaia/fauna", "actor|fauna/", "actor|particle/", "skirmish/", "trigger/")
"""Who lives, and what is nothing to see, is left out."""
SOFT = ("water", "grass", "fern", "flower", "reeds", "shrub_tropic_plant")
"""What begins so has no body: nothing stands on it or meets it."""
GROWS = ("flora", "fruit", "tree", "bush")
LOOKS = 3
"""Looks that one actor has at the most: of its variants that many draws are made."""
TRUNK, TRUNK_CM = 0.03, (8.0, 60.0)
"""Half the width of a trunk by the height of its tree, and in cm."""
GAP_CM = 0.2
"""What stands is so far above the ground: what sinks by a rounding error counts as floating."""
SUN, TINT = 1.4, 0.5
"""Strength of the sun, and how much of its colour is the one that the map tells: a map's may lack a channel."""


def read_map(path: Path, member: str, square: Square) -> ImportedScene:
    """A square of the map ``member`` (``maps/scenarios/x.xml``) of an archive.

    Units, animals and effects are left out. Of an actor, the props that stand on the ground by themselves are things of
    their own; what is on level ground is cut off below it, for makers of maps sink things in.
    """
    with Archive(path) as archive:
        return _Map(archive, member, square).read()


@dataclass(frozen=True)
class _Kept:
    """A piece of a look: its asset's key, where its foot is, its plan, and whether it may be on level ground only."""

    asset: str
    foot: Matrix
    low: Matrix
    high: Matrix


class _Map:
    def __init__(self, archive: Archive, member: str, square: Square) -> None:
        self.archive, self.member = archive, member
        self.root = archive.xml(member)
        terrain = read_pmp(archive.data(member.removesuffix(".xml") + ".pmp"), member)
        water = float(self.root.findtext("Environment/Water/WaterBody/Height") or -1000)
        self.square = square
        self.ground = MapGround(terrain, square, water)
        self.scene = ImportedScene(metric=True)
        self.shapes = Shapes(archive)
        self.looks: dict[tuple[str, int, bool], list[_Kept]] = {}
        self.names: Counter[str] = Counter()

    def read(self) -> ImportedScene:
        scene = self.scene
        for entity in self.root.iterfind("Entities/Entity"):
            name = (entity.findtext("Template") or "").strip()
            place, turn = entity.find("Position"), entity.find("Orientation")
            if place is None or name.startswith(ALIVE):
                continue
            east, north = float(place.get("x", 0)), float(place.get("z", 0))
            if not self.square.holds(east, north):
                continue
            try:
                self._place(
                    name, int(entity.get("uid", 0)), east, north, float(turn.get("y", 0)) if turn is not None else 0
                )
            except BadInput as error:
                scene.skip(name, error.what)
        scene.assets["ground"] = self.ground.asset(self.archive)
        scene.actors.append(SceneActor("Ground", "ground", np.eye(4)))
        water = self.ground.water_asset()
        if water is not None:
            scene.assets["water"] = water
            scene.actors.append(SceneActor("Water", "water", np.eye(4)))
        scene.lights.append(_sun(self.root))
        for name, reason in sorted(self.shapes.missing.items()):
            scene.note(name, reason)
        return scene

    def _place(self, name: str, uid: int, east: float, north: float, turn: float) -> None:
        template = template_of(self.archive, name)
        up = self.ground.height(east, north)
        if template.floats:
            up = max(up, self.ground.water)
        middle = self.square.middle_m
        pose = np.eye(4)
        c, s = math.cos(turn + math.pi), math.sin(turn + math.pi)
        pose[:3, :3] = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]], dtype=float)
        pose[:3, 3] = (east - middle[0], up, north - middle[1])
        matrix = turned(pose)
        whole = self._look(template.actor, uid % LOOKS, level=False)
        reach = max(float(np.abs([one.low[:2], one.high[:2]]).max()) for one in whole) / 100
        level = not template.floats and self._level(east, north, reach if len(whole) == 1 else min(reach, 12.0))
        self.names[template.actor] += 1
        label = f"{template.actor.rpartition('/')[2].removesuffix('.xml')}_{self.names[template.actor]}"
        for piece in self._look(template.actor, uid % LOOKS, level=level):
            at = matrix.copy()
            at[:3, 3] = matrix[:3, :3] @ piece.foot + matrix[:3, 3]
            if level:
                at[2, 3] += GAP_CM
            asset = self.scene.assets[piece.asset].name
            folder = f"{label}/{asset}" if len(self._look(template.actor, uid % LOOKS, level=level)) > 1 else label
            self.scene.actors.append(SceneActor(folder, piece.asset, at))

    def _level(self, east: float, north: float, reach: float) -> bool:
        place = np.array([east, north])
        return self.ground.level_under(place - reach, place + reach)

    def _look(self, actor: str, number: int, *, level: bool) -> list[_Kept]:
        key = (actor, number, level)
        if key not in self.looks:
            self.looks[key] = self._made(actor, number, level)
        return self.looks[key]

    def _made(self, actor: str, number: int, level: bool) -> list[_Kept]:
        shapes = self.shapes.of(actor, random.Random(f"{actor}|{number}"))
        name = actor.rpartition("/")[2].removesuffix(".xml")
        grows = any(word in actor for word in GROWS)
        pieces = [ActorPiece(name, [shape.part for shape in shapes])] if grows or not level else split(name, shapes)
        found = []
        for count, piece in enumerate(pieces):
            if level:
                piece = ActorPiece(
                    piece.name, [cut for part in piece.parts if (cut := cut_at_ground(part)) is not None]
                )
                if not piece.parts:
                    continue
            own = piece.box[0][2] if level else 0.0
            low = piece.box
            around, foot = about_its_foot(piece, float(own)) if level else (piece, np.zeros(3))
            if level and own < 15.0:
                foot[2] = 0.0
            key = f"{actor}|{number}|{level}|{count}"
            bodies: list[CollisionBody] = [_trunk(around)] if grows and not piece.name.startswith(SOFT) else []
            self.scene.assets[key] = SceneAsset(piece.name, around.parts, bodies, ground=grows)
            found.append(_Kept(key, foot, *low))
        if not found:
            raise BadInput("all of it is under the ground", where=actor)
        return found


def _trunk(piece: ActorPiece) -> BoxBody:
    """The body of what grows: its trunk, so that things may stand under its leaves."""
    low, high = piece.box
    tall = float(high[2] - max(low[2], 0.0))
    foot = np.concatenate([part.vertices for part in piece.parts])
    near = foot[foot[:, 2] < max(low[2], 0.0) + 0.15 * tall + 5.0]
    middle = (near.min(axis=0) + near.max(axis=0))[:2] / 2 if len(near) else np.zeros(2)
    half = min(max(TRUNK * tall, TRUNK_CM[0]), TRUNK_CM[1])
    x, y = (float(round(value, 2)) for value in middle)
    bottom = float(low[2])
    return BoxBody(
        center=(x, y, round(bottom + 0.4 * (float(high[2]) - bottom), 2)),
        half_extent=(round(half, 2), round(half, 2), round(0.4 * (float(high[2]) - bottom), 2)),
    )


def _sun(root: Element) -> SceneLight:
    """The sun of a map."""
    told = [root.find(f"Environment/{name}") for name in ("SunElevation", "SunRotation")]
    high, turn = (float(one.get("angle", 0.8)) if one is not None else 0.8 for one in told)
    east, up, north = math.cos(high) * math.sin(turn), -math.sin(high), math.cos(high) * math.cos(turn)
    forward = np.array([north, east, up])
    side = np.cross([0.0, 0.0, 1.0], forward)
    side /= np.linalg.norm(side)
    matrix = np.eye(4)
    matrix[:3, :3] = np.column_stack([forward, side, np.cross(forward, side)])
    tint = root.find("Environment/SunColor")
    values = [float(tint.get(name, 1)) for name in "rgb"] if tint is not None else [1.0, 1.0, 1.0]
    r, g, b = (round(1 - TINT + TINT * value / max(values), 4) for value in values)
    return SceneLight("LightSun", "directional", matrix, (r, g, b), SUN)
