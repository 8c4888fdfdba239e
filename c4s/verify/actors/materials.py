"""Material evidence, once for detecting changes and once for acceptance (scorer fact 2.4).

Change detection forgives what an editor renumbers between saves; acceptance does not.
"""

from __future__ import annotations

import re
from typing import Any, TypeAlias

_LEVEL_MARK = ":PersistentLevel."
_TRANSIENT = "/engine/transient."
_NUMBER = re.compile(r"_[0-9]+$")

SlotMap: TypeAlias = dict[tuple[str, int], str]


Identity: TypeAlias = tuple[str, str]
"""What kind of path it is, and the part of it that survives a save."""


def _identity(path: Any, dynamic: bool) -> Identity:
    text = str(path)
    if dynamic and text.casefold().startswith(_TRANSIENT):
        return "transient", ""
    if _LEVEL_MARK in text:
        owned = text.rpartition(_LEVEL_MARK)[2]
        if not dynamic:
            return "owned by the level", owned
        owner, _, name = owned.rpartition(".")
        return "dynamic, owned by the level", f"{owner}.{_NUMBER.sub('', name)}"
    return "asset", text


def _slots(record: dict[str, Any]) -> Any:
    return record.get("component_material_slots") or []


def _is_dynamic(slot: Any) -> bool:
    return isinstance(slot, dict) and slot.get("is_dynamic") is True


def comparable_slots(record: dict[str, Any]) -> Any:
    """The material slots in order, with level-owned and dynamic paths reduced to what survives a save."""
    slots = _slots(record)
    if not isinstance(slots, list):
        return slots
    return [
        {**slot, "material_path": _identity(slot["material_path"], _is_dynamic(slot))}
        if isinstance(slot, dict) and slot.get("material_path")
        else slot
        for slot in slots
    ]


def comparable_materials(record: dict[str, Any]) -> list[Identity]:
    """The material paths as a sorted multiset, reduced alike. A path is dynamic if a dynamic slot names it."""
    paths, slots = record.get("material_paths") or [], _slots(record)
    dynamic = {
        str(slot.get("material_path")).casefold()
        for slot in (slots if isinstance(slots, list) else [])
        if _is_dynamic(slot)
    }
    return sorted(
        _identity(path, str(path).casefold() in dynamic) for path in (paths if isinstance(paths, list) else [paths])
    )


def renumbered_materials(record: dict[str, Any]) -> list[str]:
    """The material paths as a sorted multiset, without the numbers of what lies in the level or is transient.

    An editor gives runtime instances new ones when it saves, marked dynamic or not: where no more than those differ,
    nobody edited anything (paper, "Final repair outcomes"). For analyses; scores go by ``comparable_materials``.
    """
    paths = record.get("material_paths") or []
    found = []
    for path in map(str, paths if isinstance(paths, list) else [paths]):
        text = path.rpartition(_LEVEL_MARK)[2] if _LEVEL_MARK in path else path
        runtime = text != path or path.casefold().startswith(_TRANSIENT)
        found.append(_NUMBER.sub("", text) if runtime else text)
    return sorted(found)


def _text(value: Any) -> str:
    return "" if value is None else str(value).strip()


def _object_path(value: Any) -> str | None:
    """A case-folded absolute path without its export quotes, or None."""
    text = _text(value)
    if text.endswith("'"):
        text = text[text.index("'") + 1 : -1]
    return text.casefold() if text.startswith("/") else None


def material_set(paths: Any) -> frozenset[str] | None:
    """Acceptance: the case-folded asset paths, or None when the evidence is no list."""
    if not isinstance(paths, list):
        return None
    return frozenset(path for value in paths if (path := _object_path(value)) is not None)


def slot_map(slots: Any) -> SlotMap | None:
    """Acceptance: (component, slot index) to case-folded path, or None when it is not measurable.

    Not measurable: no list, a dynamic slot, a null or relative material path, no component, a bad index, a slot twice.
    """
    if not isinstance(slots, list):
        return None
    found: SlotMap = {}
    for slot in slots:
        if not isinstance(slot, dict) or slot.get("is_dynamic") is True:
            return None
        path, index, owner = (
            _object_path(slot.get("material_path")),
            slot.get("slot_index"),
            _text(slot.get("component_identity")),
        )
        if (
            path is None
            or not owner
            or isinstance(index, bool)
            or not isinstance(index, int)
            or index < 0
            or (owner, index) in found
        ):
            return None
        found[owner, index] = path
    return found
