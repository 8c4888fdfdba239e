"""How much is read of what comes from outside: the one table of sizes, and its one refusal.

A bound is looked at before memory is taken for what it counts, wherever that can be counted without. What is beyond is
bad input in one line that names the bound, or in a submission the verdict that says so. ``docs/limits.md`` is made of
this table.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

from c4s.errors import BadInput

_SIZES = ((1 << 30, "GiB"), (1 << 20, "MiB"), (1 << 10, "KiB"))


@dataclass(frozen=True, slots=True)
class Bound:
    """At most ``most`` of ``unit`` in ``what``; ``unit`` ``bytes`` is told in larger ones."""

    what: str
    most: int
    unit: str

    def fault(self, found: int) -> str | None:
        """Why this much is too much, or None."""
        if found <= self.most:
            return None
        return f"{self.what} has {self._amount(found)}, more than {self._amount(self.most)}"

    def hold(self, found: int, *, where: str) -> None:
        """``BadInput`` when this is too much."""
        fault = self.fault(found)
        if fault is not None:
            raise BadInput(fault, where=where)

    def told(self) -> str:
        """The limit as a document says it."""
        return self._amount(self.most)

    def _amount(self, number: int) -> str:
        if self.unit == "bytes":
            for size, name in _SIZES:
                if number >= size:
                    return f"{number // size:,} {name}"
        return f"{number:,} {self.unit}"


BOUNDS: Final[dict[str, Bound]] = {
    # what an agent saves
    "level_bytes": Bound("a level document", 32 << 20, "bytes"),
    "level_records": Bound("a level document", 400_000, "records"),
    "level_values": Bound("a level document", 2_000_000, "values"),
    "level_actors": Bound("a level", 30_000, "actors"),
    "level_instances": Bound("a level", 100_000, "mesh instances"),
    "level_lights": Bound("a level", 1_000, "lights"),
    "actor_components": Bound("an actor", 10_000, "components"),
    "actor_tags": Bound("an actor", 1_000, "tags"),
    "component_slots": Bound("a component", 1_000, "material slots"),
    "name_length": Bound("a name", 1_023, "characters"),
    "properties_size": Bound("a set of properties", 65_536, "characters"),
    "properties_depth": Bound("a property", 8, "levels of nesting"),
    "asset_bytes": Bound("a saved asset", 256 << 10, "bytes"),
    "material_parents": Bound("a material instance", 32, "parents"),
    "content_files": Bound("a content folder", 10_000, "files"),
    "content_bytes": Bound("a content folder", 256 << 20, "bytes"),
    "content_depth": Bound("a content folder", 32, "nested folders"),
    "document_bytes": Bound("a document", 512 << 20, "bytes"),
    # what an engine answers
    "answer_bytes": Bound("an answer of an engine", 96 << 20, "bytes"),
    "answer_values": Bound("an answer of an engine", 8_000_000, "values"),
    "small_answer_bytes": Bound("an answer of an engine", 32 << 20, "bytes"),
    "log_bytes": Bound("the output of a job", 32 << 20, "bytes"),
    # meshes and pictures of packs, folders and scenes
    "mesh_bytes": Bound("a mesh file", 256 << 20, "bytes"),
    "mesh_values": Bound("a mesh file", 4_000_000, "values"),
    "mesh_numbers": Bound("a mesh file", 60_000_000, "numbers"),
    "mesh_empty_numbers": Bound("an accessor without data", 1_000_000, "numbers"),
    "mesh_nodes": Bound("a mesh file", 50_000, "placed nodes"),
    "mesh_vertices": Bound("a mesh file", 10_000_000, "vertices"),
    "picture_pixels": Bound("a picture", 1 << 26, "pixels"),
    "unpacked_bytes": Bound("a file of a bundle", 256 << 20, "bytes"),
    "unpacked_values": Bound("a file of a bundle", 16_000_000, "values"),
    "row_bytes": Bound("a row", 128 << 20, "bytes"),
    "markup_bytes": Bound("a file of XML or YAML", 64 << 20, "bytes"),
    "yaml_values": Bound("a document in YAML", 1_000_000, "values"),
    # what verifiers measure
    "bodies": Bound("a scene", 200_000, "collision bodies"),
    "box_pairs": Bound("a scene", 5_000_000, "pairs of bodies with meeting boxes"),
    "measured_pairs": Bound("a scene", 300_000, "overlapping pairs of bodies"),
    "line_pairs": Bound("a scene", 30_000_000, "pairs of a line and a body above or below it"),
}
"""By name. Values of a text in JSON are told by its commas and brackets; a record is an object in it."""


_DIGITS = bytes.maketrans(b"123456789", b"0" * 9)
_LONG_DIGITS = b"0" * 4301
"""What Python itself refuses to read as a number; others take the square of its length."""
_TEXT_OR_LONG_DIGITS = re.compile(rb'"(?:[^"\\]|\\.)*+(?:"|\Z)|([0-9]{4301})', re.DOTALL)


def long_number_in(text: bytes) -> bool:
    """Whether a text in JSON has a number of thousands of digits; digits within its texts are none."""
    if _LONG_DIGITS not in text.translate(_DIGITS):
        return False
    return any(found.group(1) is not None for found in _TEXT_OR_LONG_DIGITS.finditer(text))


def values_in(text: bytes) -> int:
    """How many values a text in JSON has at most, told without reading it: its commas and opening brackets."""
    return text.count(b",") + text.count(b"[") + text.count(b"{")
