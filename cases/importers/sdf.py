"""An SDF world (Gazebo) as a scene.

An actor is an included model, a model written out that holds no other, or one link of a model that does (a group: it
names the folder of its actors in the outliner). A model that wraps a single include is that include under its own name.
Visuals of an actor are one mesh about the pivot of its model or link; its collision elements are its bodies.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import numpy as np

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.files import digest, read_plain
from cases.importers.scene import ImportedScene, SceneActor, SceneAsset, SceneLight
from cases.importers.sdf_frames import Frames, Matrix, name_of, numbers, pose
from cases.importers.sdf_shapes import SdfShapes, to_unreal

MAX_DEPTH = 32
"""Models that include each other end here."""
SUN_INTENSITY = 4.0
POINT_INTENSITY = 8000.0
"""What a full white SDF light becomes; SDF's lights have no physical unit."""
KINDS: dict[str, Literal["point", "spot", "directional"]] = {
    "point": "point",
    "spot": "spot",
    "directional": "directional",
}
PLAIN_LINKS = {"link", "base", "body", "base_link", "root"}
"""Names of links that say nothing: the model's is taken."""
LEFT_OUT = {
    "actor": "animated people are not part of a still scene",
    "population": "a population is placed by chance when it is simulated",
    "road": "roads drawn by a simulator are not supported",
}


def scene_root(world: Path) -> Path:
    """The folder that holds the scene: the nearest one above the file with ``models``, else the file's own."""
    for folder in [world.parent, *list(world.parents)[1:3]]:
        if (folder / "models").is_dir():
            return folder
    return world.parent


@dataclass(frozen=True)
class Scope:
    """What a nested model inherits: its path, its matrix in the world, its frames, its depth, whether it is fixed."""

    prefix: str
    frame: Matrix
    frames: Frames
    depth: int
    static: bool

    def within(self, element: Element, link: Element) -> Matrix:
        """What to multiply a visual's or collision's own pose with, in its link: nothing, unless it names a frame."""
        found = element.find("pose")
        named = (found.get("relative_to") or "").strip() if found is not None else ""
        if not named:
            return np.eye(4)
        return np.linalg.inv(self.frames.of(link)) @ self.frames.resolve(named)


def read_sdf(
    world: Path, progress: Callable[[str], None] | None = None, replace: Mapping[str, str] | None = None
) -> ImportedScene:
    """Read an SDF world.

    Args:
        world: the file.
        progress: told the name of each model.
        replace: mesh addresses of the world that are read from another file (``a/door.obj#Frame``: a part of it).

    Raises:
        BadInput: the file is no SDF world. What cannot be used is named in ``skipped``.
    """
    return _Reader(world, progress or (lambda name: None), replace or {}).read()


def _tree(path: Path) -> Element:
    data = read_plain(path, bound=BOUNDS["markup_bytes"])
    if b"<!DOCTYPE" in data or b"<!ENTITY" in data:
        raise BadInput("an SDF file has no document type and no entities", where=str(path))
    try:
        return ElementTree.fromstring(data.strip())
    except (ElementTree.ParseError, LookupError, ValueError) as error:
        raise BadInput(f"this is not valid XML: {error}", where=str(path)) from None


class _Reader:
    def __init__(self, world: Path, progress: Callable[[str], None], replace: Mapping[str, str]) -> None:
        self.world, self.root, self.progress = world, scene_root(world), progress
        self.scene = ImportedScene(metric=True)
        self.shapes = SdfShapes(world, self.root, replace)
        self.models: dict[str, Element] = {}
        self.state: dict[str, Element] = {}

    def read(self) -> ImportedScene:
        tree = _tree(self.world)
        world = tree.find("world")
        if tree.tag != "sdf" or world is None:
            raise BadInput("this is no SDF world", where=str(self.world))
        self.state = {
            model.get("name", ""): model for model in world.iterfind("state/model") if model.find("pose") is not None
        }
        scope = Scope("", np.eye(4), Frames(world, self.library), 0, False)
        for element in world:
            if element.tag in ("model", "include"):
                self._guarded(element, scope)
            elif element.tag == "light":
                self._light(element, "", scope.frames.of(element))
            elif element.tag in LEFT_OUT:
                self.scene.skip(element.get("name", element.tag), LEFT_OUT[element.tag])
        return self.scene

    def _guarded(self, element: Element, scope: Scope) -> None:
        """Place one model or include; what is wrong with it does not end the import."""
        name = scope.prefix + (name_of(element) or element.findtext("uri") or "").strip()
        self.progress(name)
        try:
            if scope.depth > MAX_DEPTH:
                raise BadInput("models include each other without an end")
            self._model(element, scope)
        except BadInput as error:
            self.scene.skip(name, error.line())

    def library(self, include: Element) -> Element:
        """The model that an include stands for; ``BadInput`` when it is not among the files."""
        uri = (include.findtext("uri") or "").strip()
        if uri not in self.models:
            file = self.shapes.files.locate(f"{uri}/model.sdf")
            folder = uri.rstrip("/").rsplit("/", 1)[-1]
            if file is None or file.parent.name.lower() != folder.lower():
                raise BadInput(f"model {uri!r} is missing")
            model = _tree(file).find("model")
            if model is None:
                raise BadInput("this file holds no model", where=str(file))
            self.models[uri] = model
        return self.models[uri]

    def _model(self, element: Element, scope: Scope, as_name: str = "") -> None:
        """An include or a model: an actor when nothing but links is in it, else a group of them."""
        model = self.library(element) if element.tag == "include" else element
        name = scope.prefix + (as_name or name_of(element) or model.get("name") or "model").strip()
        static = scope.static or _true(element.findtext("static") or model.findtext("static"))
        here = self._saved(name, scope.frame @ scope.frames.of(element))
        inner = Scope(f"{name}/", here, Frames(model, self.library), scope.depth + 1, static)
        links, nested = model.findall("link"), [child for child in model if child.tag in ("model", "include")]
        for link in links:
            for light in link.findall("light"):
                self._light(light, inner.prefix, here @ inner.frames.of(link) @ pose(light))
        if len(nested) == 1 and nested[0].tag == "include" and not links and element.tag == "model":
            self._model(
                nested[0],
                Scope(scope.prefix, here, inner.frames, scope.depth + 1, static),
                name.removeprefix(scope.prefix),
            )
        elif nested:
            self._group(model, inner)
        else:
            uri = (element.findtext("uri") or "").strip() if element.tag == "include" else ""
            self._actor(name, uri, uri.rstrip("/").rsplit("/", 1)[-1] or _stem(model, links), here, links, inner)

    def _group(self, model: Element, inner: Scope) -> None:
        for child in model:
            if child.tag in ("model", "include"):
                self._guarded(child, inner)
        for link in model.findall("link"):
            if link.find("visual") is None:
                continue
            path = f"{inner.prefix}{link.get('name', 'link')}"
            try:
                name = _stem(link, [link])
                name = inner.prefix.rstrip("/").rpartition("/")[2] if name.lower() in PLAIN_LINKS else name
                self._actor(path, "", name, inner.frame @ inner.frames.of(link), [link], inner, alone=True)
            except BadInput as error:
                self.scene.skip(path, error.line())

    def _saved(self, name: str, matrix: Matrix) -> Matrix:
        """Where the world's saved state has a model, if it has it: a simulator starts from there."""
        saved = self.state.get(name)
        if saved is None:
            return matrix
        self.scene.note(name, "it stands where the world's saved state has it")
        return pose(saved) @ np.diag([*numbers(saved.findtext("scale"), 3, 1.0), 1.0])

    def _actor(
        self,
        path: str,
        key: str,
        asset_name: str,
        matrix: Matrix,
        links: list[Element],
        scope: Scope,
        alone: bool = False,
    ) -> None:
        """One actor; ``alone``: its matrix holds the pose of its only link already."""
        frames = [np.eye(4) if alone else scope.frames.of(link) for link in links]
        key = key or digest(
            [[_plain(link), np.round(frame, 6).tolist()] for link, frame in zip(links, frames, strict=True)]
        )
        if key not in self.scene.assets:
            self.scene.assets[key] = self._asset(path, asset_name, links, frames, scope)
        self.scene.actors.append(SceneActor(path, key, to_unreal(matrix), not scope.static))

    def _asset(self, path: str, name: str, links: list[Element], frames: list[Matrix], scope: Scope) -> SceneAsset:
        asset, lost = SceneAsset(name, []), list[str]()
        for link, frame in zip(links, frames, strict=True):
            for visual in link.findall("visual"):
                try:
                    parts, notes = self.shapes.visual(visual, frame @ scope.within(visual, link))
                except BadInput as error:
                    lost.append(f"visual {visual.get('name')} is left out: {error.line()}")
                    continue
                asset.parts += parts
                for text in notes:
                    self.scene.note(name, text)
            for collision in link.findall("collision"):
                try:
                    asset.collision += self.shapes.collision(collision, frame @ scope.within(collision, link))
                except BadInput as error:
                    lost.append(f"collision {collision.get('name')} is left out: {error.line()}")
        if not asset.parts:
            raise BadInput(lost[0].partition(": ")[2] if lost else "it has nothing to see")
        for text in lost:
            self.scene.note(path, text)
        return asset

    def _light(self, element: Element, prefix: str, frame: Matrix) -> None:
        name, kind = prefix + element.get("name", "light"), element.get("type", "")
        if kind not in KINDS:
            self.scene.skip(name, f"a light of type {kind!r} is not supported")
            return
        try:
            r, g, b = (min(1.0, max(0.0, value)) for value in numbers(element.findtext("diffuse"), 3, 1.0))
            strong, matrix = max(r, g, b, 1e-6), to_unreal(frame)
            level = strong * numbers(element.findtext("intensity"), 1, 1.0)[0]
            direction = np.asarray(numbers(element.findtext("direction") or "0 0 -1", 3)) * [1, -1, 1]
            cone = [
                round(float(np.degrees(numbers(element.findtext(f"spot/{part}_angle"), 1, angle)[0])) / 2, 4)
                for part, angle in (("inner", 0.6), ("outer", 1.0))
            ]
            reach = min(100 * numbers(element.findtext("attenuation/range"), 1, 10.0)[0], 100_000.0)
        except BadInput as error:
            self.scene.skip(name, error.line())
            return
        if kind != "point":
            matrix[:3, :3] = _along(matrix[:3, :3] @ direction)
        self.scene.lights.append(
            SceneLight(
                name,
                KINDS[kind],
                matrix,
                (r / strong, g / strong, b / strong),
                level * (SUN_INTENSITY if kind == "directional" else POINT_INTENSITY),
                reach,
                cone_deg=(cone[0], cone[1]) if kind == "spot" else None,
            )
        )


def _along(direction: Matrix) -> Matrix:
    """A rotation whose X axis points along a direction."""
    x = direction / max(float(np.linalg.norm(direction)), 1e-12)
    side = np.cross([0.0, 0.0, 1.0] if abs(x[2]) < 0.99 else [1.0, 0.0, 0.0], x)
    side /= np.linalg.norm(side)
    return np.stack([x, side, np.cross(x, side)], axis=1)


def _stem(element: Element, links: list[Element]) -> str:
    """A name for the mesh of an actor without a model of its own: of its only mesh file, else the element's."""
    files = {uri.text.strip() for link in links for uri in link.iterfind("visual/geometry/mesh/uri") if uri.text}
    if len(files) == 1:
        return Path(files.pop()).stem
    return re.sub(r"[-_.0-9]+$", "", element.get("name", "")) or element.get("name", "model")


def _plain(element: Element) -> list[object]:
    """What is to be seen and touched of an element as plain data, without its name and without a link's pose."""
    children = [_plain(child) for child in element if not (element.tag == "link" and child.tag == "pose")]
    return [element.tag, " ".join((element.text or "").split()), children]


def _true(text: str | None) -> bool:
    return (text or "").strip().lower() in ("true", "1")
