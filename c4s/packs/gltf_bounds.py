"""What a glTF file asks for, told from its JSON before any array is made of it.

A few hundred bytes can name thousands of millions of vertices: accessors without data, nodes that place one mesh again
and again, a compressed mesh whose head promises more than follows.
"""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.files import parse_bounded, read_plain

_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_JSON_CHUNK = 0x4E4F534A


def hold_file(path: Path) -> None:
    """``BadInput`` for a GLB or glTF file beyond the bounds; what is wrong otherwise is left to its reader."""
    data = read_plain(path, bound=BOUNDS["mesh_bytes"])
    if data[:4] == b"glTF":
        if len(data) < 20 or struct.unpack_from("<I", data, 16)[0] != _JSON_CHUNK:
            return
        data = data[20 : 20 + struct.unpack_from("<I", data, 12)[0]]
    hold_tree(read_tree(data, str(path)), str(path))


def read_tree(text: bytes, where: str) -> dict[str, Any]:
    """The JSON of a glTF file; ``BadInput`` unless it is an object within the bounds."""
    try:
        tree = parse_bounded(text.removeprefix(b"\xef\xbb\xbf"), BOUNDS["mesh_bytes"], BOUNDS["mesh_values"])
    except ValueError as error:
        raise BadInput(f"cannot read this mesh: the JSON of the file cannot be read: {error}", where=where) from None
    if not isinstance(tree, dict):
        raise BadInput("this is no glTF file: it has no asset record", where=where)
    return tree


def hold_tree(tree: dict[str, Any], where: str) -> None:
    """``BadInput`` for more numbers or placed nodes than the bounds, and for a node below itself."""
    numbers = 0
    for record in _records(tree, "accessors"):
        count = record.get("count")
        if isinstance(count, int) and count > 0:
            asked = count * _WIDTHS.get(str(record.get("type")), 1)
            numbers += asked
            if "bufferView" not in record:
                BOUNDS["mesh_empty_numbers"].hold(asked, where=where)
    BOUNDS["mesh_numbers"].hold(numbers, where=where)
    BOUNDS["mesh_nodes"].hold(_placements(_records(tree, "nodes"), where), where=where)


def _records(tree: dict[str, Any], kind: str) -> list[dict[str, Any]]:
    found = tree.get(kind)
    return [record for record in found if isinstance(record, dict)] if isinstance(found, list) else []


def _placements(nodes: list[dict[str, Any]], where: str) -> int:
    """How often nodes are placed in all: one that hangs in two places is, with all below it, there twice."""
    children = [
        [child for child in listed if isinstance(child, int) and 0 <= child < len(nodes)]
        if isinstance(listed := node.get("children"), list)
        else []
        for node in nodes
    ]
    parents = [0] * len(nodes)
    for listed in children:
        for child in listed:
            parents[child] += 1
    times = [0 if count else 1 for count in parents]
    waiting, total, seen = [index for index, count in enumerate(parents) if not count], 0, 0
    while waiting:
        index = waiting.pop()
        seen += 1
        total += times[index]
        BOUNDS["mesh_nodes"].hold(total, where=where)
        for child in children[index]:
            times[child] += times[index]
            parents[child] -= 1
            if not parents[child]:
                waiting.append(child)
    if seen < len(nodes):
        raise BadInput("a node hangs below itself", where=where)
    return total


def hold_draco(data: bytes, where: str) -> None:
    """``BadInput`` for a mesh of Draco whose head promises more faces or vertices than the bounds.

    Heads older than 2.2, which store these numbers otherwise, are refused.
    """
    if len(data) < 12 or data[:5] != b"DRACO" or data[7] != 1:
        raise BadInput("a mesh compressed with Draco cannot be read: it has no head of a mesh", where=where)
    if (data[5], data[6]) < (2, 2):
        raise BadInput(f"a mesh compressed with Draco {data[5]}.{data[6]} is not read; write it again", where=where)
    place = 12 if data[8] else 11
    for _ in range(2):
        number, place = _varint(data, place)
        BOUNDS["mesh_vertices"].hold(number, where=where)


def _varint(data: bytes, place: int) -> tuple[int, int]:
    number = shift = 0
    for byte in data[place : place + 10]:
        number |= (byte & 127) << shift
        place, shift = place + 1, shift + 7
        if byte < 128:
            break
    return number, place
