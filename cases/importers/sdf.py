"""An SDF world (Gazebo) as a scene.

An actor is an included model, a model written out that holds no other, or one link of a model that does (a group: it
names the folder of its actors in the outliner). A model that wraps a single include is that include under its own name.
Visuals of an actor are one mesh about the pivot of its model or link; its collision elements are its bodies.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import numpy as np

from c4s.errors import BadInput
from c4s.files import digest
from cases.importers.scene import ImportedScene, SceneActor, SceneAsset, SceneLight
from cases.importers.sdf_shapes import Matrix, SdfShapes, numbers, pose, to_unreal

MAX_DEPTH = 32
"""Models that include each other end here."""
SUN_INTENSITY = 4.0
POINT_INTENSITY = 8000.0
"""What a full white SDF light becomes; SDF's lights have no physical unit."""


def scene_root(world: Path) -> Path:
    """The folder that holds the scene: the nearest one above the file with ``models``, else the file's own."""
    for folder in [world.parent, *list(world.parents)[1:3]]:
        if (folder / "models").is_dir():
            return folder
    return world.parent


def read_sdf(world: Path, progress: Callable[[str], None] | None = None) -> ImportedScene:
    """Read an SDF world. ``BadInput`` when the file is none; what cannot be used is named in ``skipped``."""
    return _Reader(world, progress or (lambda name: None)).read()


def _tree(path: Path) -> Element:
    data = path.read_bytes()
    if b"<!DOCTYPE" in data or b"<!ENTITY" in data:
        raise BadInput("an SDF file has no document type and no entities", where=str(path))
    try:
        return ElementTree.fromstring(data.strip())
    except ElementTree.ParseError as error:
        raise BadInput(f"this is not valid XML: {error}", where=str(path)) from None


class _Reader:
    def __init__(self, world: Path, progress: Callable[[str], None]) -> None:
        self.world, self.root, self.progress = world, scene_root(world), progress
        self.scene = ImportedScene(metric=True)
        self.shapes = SdfShapes(world, self.root)
        self.models: dict[str, Element] = {}

    def read(self) -> ImportedScene:
        tree = _tree(self.world)
        world = tree.find("world")
        if tree.tag != "sdf" or world is None:
            raise BadInput("this is no SDF world", where=str(self.world))
        for element in world:
            if element.tag in ("model", "include"):
                self._guarded(element, "", np.eye(4), 0)
            elif element.tag == "light":
                self._light(element)
            elif element.tag == "actor":
                self.scene.skip(element.get("name", "actor"), "animated people are not part of a still scene")
        return self.scene

    def _guarded(self, element: Element, prefix: str, frame: Matrix, depth: int) -> None:
        """Place one model or include; what is wrong with it does not end the import."""
        name = prefix + (element.findtext("name") or element.get("name") or element.findtext("uri") or "").strip()
        self.progress(name)
        try:
            if depth > MAX_DEPTH:
                raise BadInput("models include each other without an end")
            if element.tag == "include":
                self._include(element, prefix, frame, depth)
            else:
                self._model(element, prefix, frame, depth)
        except BadInput as error:
            self.scene.skip(name, error.line())

    def _include(self, element: Element, prefix: str, frame: Matrix, depth: int, name: str = "") -> None:
        uri = (element.findtext("uri") or "").strip()
        model = self._library(uri)
        name = name or (element.findtext("name") or model.get("name") or uri).strip()
        here = frame @ pose(element if element.find("pose") is not None else model)
        if model.find("model") is not None or model.find("include") is not None:
            self._group(model, prefix + name, here, depth)
            return
        self._actor(prefix + name, uri, uri.rsplit("/", 1)[-1], here, model.findall("link"))

    def _library(self, uri: str) -> Element:
        if uri not in self.models:
            file = self.shapes.files.locate(f"{uri}/model.sdf")
            folder = uri.rstrip("/").rsplit("/", 1)[-1]
            if file is None or file.parent.name != folder:
                raise BadInput(f"model {uri!r} is missing")
            model = _tree(file).find("model")
            if model is None:
                raise BadInput("this file holds no model", where=str(file))
            self.models[uri] = model
        return self.models[uri]

    def _model(self, element: Element, prefix: str, frame: Matrix, depth: int) -> None:
        name, here = prefix + element.get("name", "model"), frame @ pose(element)
        includes, links = element.findall("include"), element.findall("link")
        if len(includes) == 1 and not links and element.find("model") is None:
            self._include(includes[0], prefix, here, depth + 1, element.get("name", "model"))
        elif includes or element.find("model") is not None:
            self._group(element, name, here, depth)
        else:
            self._actor(name, "", _stem(element, links), here, links)

    def _group(self, element: Element, name: str, frame: Matrix, depth: int) -> None:
        for child in element:
            if child.tag in ("model", "include"):
                self._guarded(child, f"{name}/", frame, depth + 1)
        for link in element.findall("link"):
            if link.find("visual") is None:
                continue
            path = f"{name}/{link.get('name', 'link')}"
            try:
                self._actor(path, "", _stem(link, [link]), frame @ pose(link), [link], placed=True)
            except BadInput as error:
                self.scene.skip(path, error.line())

    def _actor(self, path: str, key: str, asset_name: str, matrix: Matrix, links: list[Element],
               placed: bool = False) -> None:
        """One actor; ``placed``: its matrix holds the pose of its only link already."""
        spec = [_plain(link, skip_pose=placed) for link in links]
        key = key or digest(spec)
        if key not in self.scene.assets:
            self.scene.assets[key] = self._asset(path, asset_name, links, placed)
        self.scene.actors.append(SceneActor(path, key, to_unreal(matrix)))

    def _asset(self, path: str, name: str, links: list[Element], placed: bool) -> SceneAsset:
        asset = SceneAsset(name, [])
        for link in links:
            frame = np.eye(4) if placed else pose(link)
            for visual in link.findall("visual"):
                try:
                    parts, notes = self.shapes.visual(visual, frame)
                except BadInput as error:
                    self.scene.skip(f"{path}: visual {visual.get('name')}", error.line())
                    continue
                asset.parts += parts
                for text in notes:
                    self.scene.note(name, text)
            for collision in link.findall("collision"):
                try:
                    asset.collision += self.shapes.collision(collision, frame)
                except BadInput as error:
                    self.scene.skip(f"{path}: collision {collision.get('name')}", error.line())
        if not asset.parts:
            raise BadInput("it has nothing to see")
        return asset

    def _light(self, element: Element) -> None:
        name, kind = element.get("name", "light"), element.get("type", "")
        if kind not in ("point", "directional"):
            self.scene.skip(name, f"a light of type {kind!r} is not supported")
            return
        r, g, b = (min(1.0, max(0.0, value)) for value in numbers(element.findtext("diffuse"), 3, 1.0))
        strong = max(r, g, b, 1e-6)
        matrix = to_unreal(pose(element))
        if kind == "directional":
            matrix[:3, :3] = _along(to_unreal(pose(element))[:3, :3] @ (
                np.asarray(numbers(element.findtext("direction") or "0 0 -1", 3)) * [1, -1, 1]))
        self.scene.lights.append(SceneLight(
            name, kind, matrix, (r / strong, g / strong, b / strong),
            strong * (SUN_INTENSITY if kind == "directional" else POINT_INTENSITY),
            min(100 * numbers(element.findtext("attenuation/range"), 1, 10.0)[0], 100_000.0)))


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


def _plain(element: Element, skip_pose: bool = False) -> list[object]:
    """An element as plain data without its name (and without its own pose)."""
    children = [_plain(child) for child in element if not (skip_pose and child.tag == "pose")]
    return [element.tag, " ".join((element.text or "").split()), children]
