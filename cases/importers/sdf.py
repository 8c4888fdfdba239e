"""SDF worlds (Gazebo) as a scene.

An actor is an included model, a model written out that holds no other, a road, or one link of a model that holds others
(a group: it names the folder of its actors in the outliner). A model that wraps a single include is that include under
its own name; what a merged include holds is its parent's. Visuals of an actor are one mesh about the pivot of its model
or link; its collision elements are its bodies. Several worlds join into one scene.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from c4s.errors import BadInput
from c4s.files import digest
from cases.importers.imported import ImportedScene, SceneActor, SceneAsset
from cases.importers.sdf_frames import Frames, Matrix, merged, numbers, pose
from cases.importers.sdf_library import PLACEABLE, SdfFiles, SdfLibrary, read_tree, uri_of
from cases.importers.sdf_lights import light_of
from cases.importers.sdf_shapes import SdfShapes, to_unreal

MAX_DEPTH = 32
"""Models that include each other end here."""
PLAIN_LINKS = {"link", "base", "body", "base_link", "root"}
"""Names of links that say nothing: the model's is taken."""
LEFT_OUT = {
    "actor": ("animated person", "animated people are not part of a still scene"),
    "population": ("population", "a population is placed by chance when it is simulated"),
    "plugin": ("plugin", "a plugin is a program of the simulator"),
    "sensor": ("sensor", "a sensor is nothing to see"),
}
"""What is never part of a scene: its kind, and why."""


def scene_root(world: Path) -> Path:
    """The folder that holds the scene: the nearest one above the file with ``models``, else the file's own."""
    for folder in [world.parent, *list(world.parents)[1:3]]:
        if (folder / "models").is_dir():
            return folder
    return world.parent


@dataclass(frozen=True)
class SdfScope:
    """What a nested model inherits: its path, its matrix in the world, its frames, its depth, whether it is fixed."""

    prefix: str
    frame: Matrix
    frames: Frames
    depth: int
    static: bool


@dataclass(frozen=True)
class SdfLink:
    """A link of a model: its element, its matrix in the model, the frames among which its poses are written."""

    element: Element
    matrix: Matrix
    frames: Frames

    def within(self, child: Element) -> Matrix:
        """What to multiply a visual's or collision's own pose with, in its link: nothing, unless it names a frame."""
        found = child.find("pose")
        named = (found.get("relative_to") or "").strip() if found is not None else ""
        if not named:
            return np.eye(4)
        return np.linalg.inv(self.frames.of(self.element)) @ self.frames.resolve(named)


@dataclass(frozen=True)
class ModelContent:
    """What a model holds, with what its merged includes hold: links, and models with the frames that they stand in."""

    links: list[SdfLink]
    nested: list[tuple[Element, Frames, Matrix]]


def read_sdf(
    worlds: Sequence[Path],
    progress: Callable[[str], None] | None = None,
    replace: Mapping[str, str] | None = None,
    resources: Sequence[Path] = (),
) -> ImportedScene:
    """Read SDF worlds into one scene.

    Args:
        worlds: the files; one that holds models and no world is a world of these.
        progress: told the name of each model.
        replace: mesh addresses of the worlds that are read from another file (``a/door.obj#Frame``: a part of it).
        resources: further folders in which models and their files are looked for.

    Raises:
        BadInput: a file is no SDF. What cannot be used is named in ``skipped``.
    """
    folders = list(dict.fromkeys([*(scene_root(world) for world in worlds), *resources]))
    return _Reader(worlds, folders, progress or (lambda name: None), replace or {}).read()


class _Reader:
    def __init__(
        self,
        worlds: Sequence[Path],
        folders: Sequence[Path],
        progress: Callable[[str], None],
        replace: Mapping[str, str],
    ) -> None:
        self.worlds, self.progress = worlds, progress
        self.scene = ImportedScene(metric=True)
        files = SdfFiles(worlds[0], folders)
        self.shapes, self.library = SdfShapes(files, replace), SdfLibrary(files)
        self.state: dict[str, Element] = {}

    def read(self) -> ImportedScene:
        for path in self.worlds:
            tree = read_tree(path)
            worlds = tree.findall("world") or ([tree] if any(tree.find(tag) is not None for tag in PLACEABLE) else [])
            if tree.tag != "sdf" or not worlds:
                raise BadInput("this is no SDF world", where=str(path))
            for world in worlds:
                self._world(world, SdfScope("", np.eye(4), Frames(world, self.library), 0, False))
        for name in sorted(self.library.own):
            self.scene.note(name, "no file of this model is there: Gazebo's own is taken")
        return self.scene

    def _world(self, world: Element, scope: SdfScope) -> None:
        self.state = {
            scope.prefix + model.get("name", ""): model
            for model in world.iterfind("state/model")
            if model.find("pose") is not None
        }
        for element in world:
            if element.tag in ("model", "include", "light", "road"):
                self._guarded(element, scope)
        self._leave_out(world, scope.prefix)

    def _guarded(self, element: Element, scope: SdfScope) -> None:
        """Place a model, an include, a light or a road; what is wrong with it does not end the import."""
        name = scope.prefix + self._name(element)
        self.progress(name)
        try:
            if scope.depth > MAX_DEPTH:
                raise BadInput("models include each other without an end")
            if element.tag == "light":
                self._light(element, name, scope.frame @ scope.frames.of(element))
            elif element.tag == "road":
                self._road(element, name, scope)
            else:
                self._placed(element, scope)
        except BadInput as error:
            self.scene.skip(name, error.line(), error.what)

    def _name(self, element: Element) -> str:
        name = self.library.name(element) if element.tag == "include" else element.get("name") or ""
        return name.strip() or element.tag

    def _placed(self, element: Element, scope: SdfScope) -> None:
        """An include of whatever it stands for, or a model."""
        target = self.library(element) if element.tag == "include" else element
        name, here = scope.prefix + self._name(element), scope.frame @ scope.frames.of(element)
        if target.tag == "light":
            self._light(target, name, here)
        elif target.tag == "actor":
            self.scene.skip(name, LEFT_OUT["actor"][1], LEFT_OUT["actor"][0])
        elif target.tag == "world":
            given = (element.findtext("name") or "").strip()
            prefix = f"{scope.prefix}{given}/" if given else scope.prefix
            state = self.state
            self._world(target, SdfScope(prefix, here, Frames(target, self.library), scope.depth + 1, scope.static))
            self.state = state
        else:
            self._model(element, target, scope, name)

    def _model(self, element: Element, model: Element, scope: SdfScope, name: str) -> None:
        """A model: an actor when nothing but links is in it, else a group of them."""
        static = scope.static or _true(element.findtext("static") or model.findtext("static"))
        here = self._saved(name, scope.frame @ scope.frames.of(element))
        inner = SdfScope(f"{name}/", here, Frames(model, self.library), scope.depth + 1, static)
        content = self._content(model, inner.frames, np.eye(4), inner)
        self._leave_out(model, inner.prefix)
        lights = 0
        for link in content.links:
            for light in link.element.findall("light"):
                self._guarded_light(light, inner.prefix, here @ link.matrix @ pose(light))
                lights += 1
        if len(content.nested) == 1 and not content.links and element.tag == "model" and _includes_model(content):
            child, frames, base = content.nested[0]
            wrapped = SdfScope(scope.prefix, here @ base, frames, scope.depth + 1, static)
            target = self.library(child)
            if target.tag == "model":
                self._model(child, target, wrapped, name)
                return
        if content.nested:
            self._group(content, inner)
        elif lights and not any(link.element.find("visual") is not None for link in content.links):
            return
        else:
            uri = uri_of(element) if element.tag == "include" else ""
            title = (model.get("name") or "") if uri.lower().endswith(".sdf") else uri.rstrip("/").rsplit("/", 1)[-1]
            stem = title or _stem(model, [link.element for link in content.links])
            self._actor(name, uri, stem, here, content.links, static)

    def _content(self, model: Element, frames: Frames, base: Matrix, scope: SdfScope, depth: int = 0) -> ModelContent:
        """Links and models of a model; ``base``: where a merged one stands in its parent."""
        if depth > MAX_DEPTH:
            raise BadInput("models include each other without an end")
        found = ModelContent([], [])
        for child in model:
            try:
                if child.tag == "link":
                    found.links.append(SdfLink(child, base @ frames.of(child), frames))
                elif merged(child) and (target := self.library(child)).tag == "model":
                    inside = Frames(target, self.library)
                    more = self._content(target, inside, base @ frames.of(child), scope, depth + 1)
                    found.links.extend(more.links)
                    found.nested.extend(more.nested)
                elif child.tag in ("model", "include"):
                    found.nested.append((child, frames, base))
            except BadInput as error:
                self.scene.skip(scope.prefix + self._name(child), error.line(), error.what)
        return found

    def _group(self, content: ModelContent, inner: SdfScope) -> None:
        for child, frames, base in content.nested:
            self._guarded(child, SdfScope(inner.prefix, inner.frame @ base, frames, inner.depth, inner.static))
        for link in content.links:
            if link.element.find("visual") is None:
                continue
            path = f"{inner.prefix}{link.element.get('name', 'link')}"
            try:
                name = _stem(link.element, [link.element])
                name = inner.prefix.rstrip("/").rpartition("/")[2] if name.lower() in PLAIN_LINKS else name
                alone = SdfLink(link.element, np.eye(4), link.frames)
                self._actor(path, "", name, inner.frame @ link.matrix, [alone], inner.static)
            except BadInput as error:
                self.scene.skip(path, error.line(), error.what)

    def _saved(self, name: str, matrix: Matrix) -> Matrix:
        """Where the world's saved state has a model, if it has it: a simulator starts from there."""
        saved = self.state.get(name)
        if saved is None:
            return matrix
        self.scene.note(name, "it stands where the world's saved state has it")
        return pose(saved) @ np.diag([*numbers(saved.findtext("scale"), 3, 1.0), 1.0])

    def _actor(
        self, path: str, key: str, asset_name: str, matrix: Matrix, links: Sequence[SdfLink], static: bool
    ) -> None:
        """One actor of links whose matrices are about its own pivot."""
        key = key or digest([[_plain(link.element), np.round(link.matrix, 6).tolist()] for link in links])
        if key not in self.scene.assets:
            self.scene.assets[key] = self._asset(path, asset_name, links)
        self.scene.actors.append(SceneActor(path, key, to_unreal(matrix), not static))

    def _asset(self, path: str, name: str, links: Sequence[SdfLink]) -> SceneAsset:
        ground = any(link.element.find("visual/geometry/heightmap") is not None for link in links)
        asset, lost = SceneAsset(name, [], ground=ground), Counter[str]()
        for link in links:
            for visual in link.element.findall("visual"):
                try:
                    parts, notes = self.shapes.visual(visual, link.matrix @ link.within(visual))
                except BadInput as error:
                    lost[f"left out of what is seen: {error.line()}"] += 1
                    continue
                asset.parts += parts
                for text in notes:
                    self.scene.note(name, text)
            for collision in link.element.findall("collision"):
                try:
                    asset.collision += self.shapes.collision(collision, link.matrix @ link.within(collision))
                except BadInput as error:
                    lost[f"left out of what can be touched: {error.line()}"] += 1
        if not asset.parts:
            raise BadInput(next(iter(lost)).partition(": ")[2] if lost else "it has nothing to see")
        for text, count in lost.items():
            self.scene.note(path, f"{count} {text}")
        return asset

    def _road(self, element: Element, name: str, scope: SdfScope) -> None:
        notes = list[str]()
        middle, part, slabs = self.shapes.road(element, notes)
        place = np.eye(4)
        place[:3, 3] = middle
        self.scene.assets[f"road|{name}"] = SceneAsset(_bare(name) or "road", [part], slabs, ground=True)
        self.scene.actors.append(SceneActor(name, f"road|{name}", to_unreal(scope.frame @ place)))
        for text in notes:
            self.scene.note(name, text)

    def _light(self, element: Element, name: str, frame: Matrix) -> None:
        self.scene.lights.append(light_of(element, name, frame))

    def _guarded_light(self, element: Element, prefix: str, frame: Matrix) -> None:
        name = prefix + element.get("name", "light")
        try:
            self._light(element, name, frame)
        except BadInput as error:
            self.scene.skip(name, error.line(), error.what)

    def _leave_out(self, element: Element, prefix: str) -> None:
        """Notes what of a world or model, its links and joints included, is never part of a scene."""
        for part in [element, *element.findall("link"), *element.findall("joint")]:
            for child in part:
                if child.tag in LEFT_OUT:
                    kind, why = LEFT_OUT[child.tag]
                    self.scene.skip(prefix + child.get("name", child.tag), why, kind)


def _includes_model(content: ModelContent) -> bool:
    return content.nested[0][0].tag == "include"


def _bare(name: str) -> str:
    """A name without its path and without the number at its end."""
    return re.sub(r"[-_.0-9]+$", "", name.rpartition("/")[2])


def _stem(element: Element, links: list[Element]) -> str:
    """A name for the mesh of an actor without a model of its own: of its only mesh file, else the element's."""
    files = {uri.text.strip() for link in links for uri in link.iterfind("visual/geometry/mesh/uri") if uri.text}
    if len(files) == 1:
        return Path(files.pop()).stem
    return _bare(element.get("name", "")) or element.get("name", "model")


def _plain(element: Element) -> list[object]:
    """What is to be seen and touched of an element as plain data, without its name and without a link's pose."""
    children = [_plain(child) for child in element if not (element.tag == "link" and child.tag == "pose")]
    return [element.tag, " ".join((element.text or "").split()), children]


def _true(text: str | None) -> bool:
    return (text or "").strip().lower() in ("true", "1")
