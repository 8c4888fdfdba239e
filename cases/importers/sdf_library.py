"""What an SDF file includes: models, lights and worlds of other files, by the addresses that SDF uses.

``model://name``, a Fuel address, a folder or a file, looked for in the scene's own folders alone. A folder's
``model.config`` tells its file, else ``model.sdf`` is taken. The sun and the ground plane that every Gazebo brings
along are known where no file of theirs is there.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.files import read_plain
from catalog.ingest.resolver import FolderResolver

SDF_SUFFIXES = (".sdf", ".world")
PLACEABLE = ("model", "light", "actor", "world")
OWN = {
    "sun": "<sdf><light name='sun' type='directional'><pose>0 0 10 0 0 0</pose><diffuse>0.8 0.8 0.8 1</diffuse>"
    "<direction>-0.5 0.1 -0.9</direction></light></sdf>",
    "ground_plane": "<sdf><model name='ground_plane'><static>true</static><link name='link'>"
    "<collision name='collision'><geometry><plane><size>100 100</size></plane></geometry></collision>"
    "<visual name='visual'><geometry><plane><size>100 100</size></plane></geometry>"
    "<material><script><name>Gazebo/Grey</name></script></material></visual></link></model></sdf>",
}
"""Gazebo's own, which nearly every world includes and no world ships: a plain sun, and 100 x 100 m of grey ground."""


def parsed(data: bytes, where: str) -> Element:
    """The root element of an SDF file; ``BadInput`` for what is no XML, and for entities."""
    if b"<!DOCTYPE" in data or b"<!ENTITY" in data:
        raise BadInput("an SDF file has no document type and no entities", where=where)
    try:
        return ElementTree.fromstring(data.strip())
    except (ElementTree.ParseError, LookupError, ValueError) as error:
        raise BadInput(f"this is not valid XML: {error}", where=where) from None


def read_tree(path: Path) -> Element:
    """The root element of an SDF file."""
    return parsed(read_plain(path, bound=BOUNDS["markup_bytes"]), str(path))


def uri_of(include: Element) -> str:
    """The address of an include."""
    return (include.findtext("uri") or include.get("filename") or "").strip()


def last_name(uri: str) -> str:
    """What an address calls its model: the last part that is no version (``model://a/b.sdf``: ``b``)."""
    parts = [part for part in re.split(r"[/\\]+", unquote(uri).split("://", 1)[-1]) if part]
    while len(parts) > 1 and (parts[-1].isdigit() or parts[-1] == "tip"):
        parts.pop()
    name = parts[-1] if parts else ""
    if name in ("model.sdf", "model.urdf") and len(parts) > 1:
        name = parts[-2]
    return Path(name).stem if name.endswith(SDF_SUFFIXES) else name


class SdfFiles:
    """Files of a scene by the names that SDF gives them; nothing outside the folders is read.

    Args:
        beside: the world file; files beside it come first.
        folders: the only folders that are read.
    """

    def __init__(self, beside: Path, folders: Sequence[Path]) -> None:
        self.folders = [Path(os.path.realpath(folder)) for folder in folders]
        self.beside = beside
        self._resolvers = [FolderResolver(beside, folder) for folder in self.folders]
        self._found: dict[str, Path | None] = {}

    def locate(self, name: str) -> Path | None:
        """The file called ``name``, or ``None``."""
        if name not in self._found:
            hits = (resolver.locate(name) for resolver in self._resolvers)
            self._found[name] = next((hit for hit in hits if hit is not None), None)
        return self._found[name]

    def folder_of(self, path: Path) -> Path:
        """The folder that a located file belongs to: its own files are looked for there."""
        real = Path(os.path.realpath(path))
        return next((folder for folder in self.folders if real.is_relative_to(folder)), path.parent)


class SdfLibrary:
    """Reads what includes stand for, each file once."""

    def __init__(self, files: SdfFiles) -> None:
        self.files = files
        self.own: set[str] = set()
        """Names of Gazebo's own models that had to be taken."""
        self._read: dict[str, Element] = {}

    def __call__(self, include: Element) -> Element:
        """The model, light, actor or world that an include stands for; ``BadInput`` where no file has it."""
        uri = uri_of(include)
        if uri not in self._read:
            self._read[uri] = self._element(uri)
        return self._read[uri]

    def name(self, include: Element) -> str:
        """What an include is called: its own name, else that of what it stands for, else what its address says."""
        given = (include.findtext("name") or include.get("name") or "").strip()
        if given:
            return given
        try:
            return self(include).get("name") or last_name(uri_of(include))
        except BadInput:
            return last_name(uri_of(include))

    def _element(self, uri: str) -> Element:
        if not uri:
            raise BadInput("an include has no address")
        path, name = self._file(uri), last_name(uri)
        if path is not None:
            tree, where = read_tree(path), str(path)
        elif name in OWN:
            self.own.add(name)
            tree, where = parsed(OWN[name].encode(), name), name
        else:
            raise BadInput(f"model {uri!r} is missing")
        if tree.tag == "robot":
            raise BadInput("a robot described in URDF is not part of a scene", where=where)
        for tag in PLACEABLE:
            found = tree.find(tag)
            if found is not None:
                return found
        raise BadInput("this file holds no model", where=where)

    def _file(self, uri: str) -> Path | None:
        if uri.lower().endswith(SDF_SUFFIXES):
            return self.files.locate(uri)
        names = ["model.sdf"]
        parts = [part for part in unquote(uri).split("://", 1)[-1].split("/") if part]
        folder = last_name(uri).lower()
        config = self.files.locate(f"{'/'.join(parts)}/model.config")
        if config is not None and folder in _above(config):
            names = [*_told(config), *names]
        for name in names:
            path = self.files.locate(f"{'/'.join(parts)}/{name}")
            if path is not None and folder in _above(path):
                return path
        return None


def _above(path: Path) -> set[str]:
    """Names of the two folders above a file: a model's own, and that above a version's (``desk/3/model.sdf``)."""
    return {path.parent.name.lower(), path.parent.parent.name.lower() if path.parent.name.isdigit() else ""}


def _told(config: Path) -> list[str]:
    """The SDF files that a ``model.config`` names, of the newest version first."""
    try:
        tree = read_tree(config)
    except BadInput:
        return []
    listed = [(found.get("version") or "", (found.text or "").strip()) for found in tree.iterfind("sdf")]
    return [name for _, name in sorted(listed, key=lambda row: _version(row[0]), reverse=True) if name]


def _version(text: str) -> tuple[int, ...]:
    return tuple(int(part) for part in re.findall(r"\d+", text))
