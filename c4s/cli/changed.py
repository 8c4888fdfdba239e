"""What a script changed in a level: two snapshots of it, compared actor by actor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

Snapshot = Mapping[str, Any]
Facts = dict[str, Any]
MOVED = {"location_cm": 1e-3, "rotation_deg": 1e-4, "scale": 1e-6}
"""Parts of a transform, and how much of each is no change."""
LISTED = 40
"""Actors of a kind that are told one by one to a person; the counts are of all."""
MOST_ITEMS = 5
"""Items of a list that are told to a person."""


def changes(before: Snapshot, after: Snapshot) -> Facts:
    """``{"added", "removed", "changed"}``: the actors by their guid, each with its label, name, class and assets.

    A changed actor has ``what``: by the name of each thing that differs ``[before, after]``.
    """
    old = {actor["actor_guid"]: actor for actor in before["actors"]}
    new = {actor["actor_guid"]: actor for actor in after["actors"]}
    both = [(new[guid], _differences(_facts(old[guid]), _facts(new[guid]))) for guid in new if guid in old]
    return {
        "added": [{**_named(new[guid]), **_placed(new[guid])} for guid in new if guid not in old],
        "removed": [_named(old[guid]) for guid in old if guid not in new],
        "changed": [{**_named(actor), "what": what} for actor, what in both if what],
    }


def lines(found: Facts) -> list[str]:
    """The changes as people read them: a line a count, and a line an actor."""
    told = []
    for kind, sign in (("added", "+"), ("removed", "-"), ("changed", "~")):
        rows = found[kind]
        told.append(f"{len(rows)} {kind}")
        told += [f"  {sign} {_line(row)}" for row in rows[:LISTED]]
        if len(rows) > LISTED:
            told.append(f"  … and {len(rows) - LISTED} more")
    return told


def _named(actor: Mapping[str, Any]) -> Facts:
    return {
        "label": actor["label"],
        "name": actor["name"],
        "class": actor["class"],
        "assets": actor["component_asset_paths"],
    }


def _placed(actor: Mapping[str, Any]) -> Facts:
    return {part: actor["transform"][part] for part in MOVED}


def _facts(actor: Mapping[str, Any]) -> Facts:
    """All that a change is told of, by the name that it is told under."""
    own = actor["c4s"]
    parts = {part["name"]: part for part in own["components"]}
    return {
        **_named(actor),
        **_placed(actor),
        "tags": actor["actor_tags"],
        "folder": actor["export_diagnostics"]["folder_path"],
        "attached_to": actor["attachment_parent_label"],
        **{
            f"collision {part['name']}": part["collision_enabled"]
            for part in actor["collision"]["collision_enabled_components"]
        },
        "hidden": own["hidden"],
        "components": sorted(parts),
        "bounds_cm": [round(value, 2) for side in actor["bounds"].values() for value in side],
        **{
            f"material {slot['component_identity'].partition('|')[0]}[{slot['slot_index']}]": slot["material_path"]
            for slot in actor["component_material_slots"]
        },
        **{f"instances {name}": len(part["instances"]) for name, part in parts.items() if "instances" in part},
        **actor["properties"],
    }


def _differences(old: Facts, new: Facts) -> Facts:
    found = {
        name: [old.get(name), new.get(name)]
        for name in dict.fromkeys([*old, *new])
        if not _same(name, old.get(name), new.get(name))
    }
    if len(found) > 1:
        found.pop("bounds_cm", None)  # they follow from what else changed
    return found


def _same(name: str, old: Any, new: Any) -> bool:
    if name in MOVED:
        return all(abs(a - b) <= MOVED[name] for a, b in zip(old, new, strict=True))
    return bool(old == new)


def _line(row: Facts) -> str:
    name = row["label"] if row["label"] == row["name"] else f"{row['label']} ({row['name']})"
    if "what" in row:
        return f"{name}: " + ", ".join(f"{key} {_short(a)} → {_short(b)}" for key, (a, b) in row["what"].items())
    kind = row["class"].rpartition(".")[2]
    assets = _short([path.rpartition(".")[2] for path in row["assets"]]) if row["assets"] else ""
    place = f"at {_short(row['location_cm'])}" if "location_cm" in row else ""
    return " ".join(part for part in (f"{name}:", kind, assets, place) if part)


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Sequence) and not isinstance(value, str):
        more = f" … {len(value) - MOST_ITEMS} more" if len(value) > MOST_ITEMS else ""
        return f"({', '.join(map(_short, value[:MOST_ITEMS]))}{more})"
    return "–" if value in (None, "") else str(value)
