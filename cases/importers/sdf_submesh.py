"""What the parts of a mesh file are called where SDF chooses one (``<submesh>``): by the name of its node.

Gazebo names a submesh after the node that shows it; authors also write the name of the geometry, or its id.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from c4s.bounds import BOUNDS
from c4s.files import read_plain
from catalog.ingest.surface import SourcePart

MOST_DEPTH = 64


def part_names(path: Path, parts: Sequence[SourcePart]) -> list[set[str]]:
    """For each part of a read file all that it may be called, in small letters."""
    names = [{part.node.lower()} for part in parts]
    if path.suffix.lower() == ".dae":
        _collada(path, parts, names)
    return names


def _collada(path: Path, parts: Sequence[SourcePart], names: list[set[str]]) -> None:
    """Adds the names of a DAE file's nodes and geometries. Parts of one geometry lie in the order of their nodes."""
    try:
        tree = ElementTree.fromstring(read_plain(path, bound=BOUNDS["mesh_bytes"]))
    except ElementTree.ParseError:
        return
    for element in tree.iter():
        element.tag = element.tag.rpartition("}")[2]
    shown: dict[str, list[set[str]]] = defaultdict(list)
    library = {node.get("id", ""): node for node in tree.iter("node")}
    for scene in tree.iter("visual_scene"):
        for node in scene.findall("node"):
            _walk(node, library, shown, set(), 0)
    called = {geometry.get("id", ""): geometry.get("name") or "" for geometry in tree.iter("geometry")}
    owned: dict[str, list[int]] = defaultdict(list)
    for number, part in enumerate(parts):
        known = part.node if part.node in called else re.sub(r"_\d+$", "", part.node)
        owned[known].append(number)
    for geometry, numbers in owned.items():
        places = shown.get(geometry, [])
        every = len(numbers) // len(places) if places and len(numbers) % len(places) == 0 else 0
        for order, number in enumerate(numbers):
            nodes = [places[order // every]] if every else places
            told = {geometry, called.get(geometry, ""), *(name for one in nodes for name in one)}
            names[number] |= {name.lower() for name in told if name}


def _walk(
    node: Element, library: dict[str, Element], shown: dict[str, list[set[str]]], above: set[str], depth: int
) -> None:
    """Notes under each geometry's id what its nodes are called: by their own names and those of the groups above."""
    if depth > MOST_DEPTH:
        return
    own = above | {name for name in (node.get("name"), node.get("id"), node.get("sid")) if name}
    for child in node:
        if child.tag in ("instance_geometry", "instance_controller"):
            shown[child.get("url", "").removeprefix("#")].append(own)
        elif child.tag == "node":
            _walk(child, library, shown, own, depth + 1)
        elif (
            child.tag == "instance_node" and (there := library.get(child.get("url", "").removeprefix("#"))) is not None
        ):
            _walk(there, library, shown, own, depth + 1)
