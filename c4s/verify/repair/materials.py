"""Material evidence, once for detecting changes and once for acceptance (scorer fact 2.4).

Change detection forgives what an editor renumbers between saves; acceptance does not.
"""

from __future__ import annotations

import re
from typing import Any, TypeAlias

_LEVEL_MARK = ":PersistentLevel."
_TRANSIENT = "/engine/transient."
_NUMBER = re.compile(r"_\d+$")

SlotMap: TypeAlias = dict[tuple[str, int], str]


def _reduced(path: Any, dynamic: bool) -> Any:
    if not isinstance(path, str):
        return path
    if dynamic and path.casefold().startswith(_TRANSIENT):
        return "<dynamic>"
    if _LEVEL_MARK in path:
        tail = path.rpartition(_LEVEL_MARK)[2]
        return _NUMBER.sub("", tail) if dynamic else tail
    return path


def _slots(record: dict[str, Any]) -> list[Any]:
    slots = record.get("component_material_slots")
    return slots if isinstance(slots, list) else []


def comparable_slots(record: dict[str, Any]) -> list[Any]:
    """The material slots in order, with level-owned and dynamic paths reduced to what survives a save."""
    return [{**slot, "material_path": _reduced(slot.get("material_path"), slot.get("is_dynamic") is True)}
            if isinstance(slot, dict) else slot for slot in _slots(record)]


def comparable_materials(record: dict[str, Any]) -> list[str]:
    """The material paths as a sorted multiset, reduced alike. A path is dynamic if a dynamic slot names it."""
    paths = record.get("material_paths")
    dynamic = {slot.get("material_path") for slot in _slots(record)
               if isinstance(slot, dict) and slot.get("is_dynamic") is True
               and isinstance(slot.get("material_path"), str)}
    return sorted(str(_reduced(path, isinstance(path, str) and path in dynamic))
                  for path in (paths if isinstance(paths, list) else []))


def material_set(paths: Any) -> frozenset[str] | None:
    """Acceptance: the case-folded asset paths, or None when the evidence is no list."""
    if not isinstance(paths, list):
        return None
    return frozenset(path.casefold() for path in paths if isinstance(path, str) and path.startswith("/"))


def slot_map(slots: Any) -> SlotMap | None:
    """Acceptance: (component, slot index) to case-folded path, or None when it is not measurable.

    Not measurable: no list, a dynamic slot, a null or relative material path, a bad index, or a slot twice.
    """
    if not isinstance(slots, list):
        return None
    found: SlotMap = {}
    for slot in slots:
        if not isinstance(slot, dict) or slot.get("is_dynamic"):
            return None
        path, index, owner = slot.get("material_path"), slot.get("slot_index"), slot.get("component_identity")
        if not isinstance(path, str) or not path.startswith("/"):
            return None
        if isinstance(index, bool) or not isinstance(index, int) or index < 0 or not isinstance(owner, str):
            return None
        if (owner, index) in found:
            return None
        found[owner, index] = path.casefold()
    return found
