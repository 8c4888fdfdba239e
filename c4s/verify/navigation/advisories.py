"""What a navigation verdict says beside its score: ways to a high score that are no use to a body.

The published rule counts every floor-level actor that collides, so small, hidden, stacked or renamed ones move it. The
score stays the rule's; each note names the actors, and what approachability is without them.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any, Final

from c4s.navigation import approachable
from c4s.protocol.navigation import AGENT_RADIUS_CM, BELOW_CM, PLATE_CM, TOWER_CM
from c4s.records.navigation import LETTERS, Fall, NavigationEvidence, TargetRecord
from c4s.verify.actors.collision import bodied_meshes, is_switched_off

TINY_CM: Final = 15.0
"""A target whose longest side is shorter is nothing that one walks up to."""
GIANT_CM: Final = 3000.0
"""A target with a longer side is reached somewhere in nearly every scene."""
PLACE_CM: Final = 100.0
FLOOR_CM: Final = 200.0
"""What is at least so wide both ways is a floor to stand on, whatever it is called."""
CROWD_SHARE: Final = 0.5
"""Targets of which fewer than this share stand in places of their own, a metre apart, are a crowd."""
NAMED_SHARE: Final = 0.05


def advisories_of(
    evidence: NavigationEvidence, snapshot: Mapping[str, Any], pool: Sequence[TargetRecord]
) -> list[dict[str, Any]]:
    """The notes of one scene."""
    settled = [build for build in evidence.builds if build.settled]
    falls = [LETTERS[letter] for letter in settled[-1].falls] if settled else []
    notes = [
        _note("hidden_targets", "these targets collide but no picture shows them", pool, falls, _hidden(pool)),
        _note("tiny_targets", f"no side of these targets reaches {TINY_CM:.0f} cm", pool, falls, _tiny(pool)),
        _note("giant_targets", f"a side of these targets is over {GIANT_CM / 100:.0f} m", pool, falls, _giant(pool)),
        _note(
            "crowded_targets",
            "most targets share their place with others: each further one counts as much as one far away",
            pool,
            falls,
            _crowded(pool),
        ),
        _note(
            "buried_targets",
            "these lie more than 50 cm under what one walks on, so they count as scenery; a floor over what cannot be "
            "reached takes it out of the pool",
            pool,
            falls,
            {row for row, fall in enumerate(falls) if fall == "buried"},
        ),
        _undermined(evidence, pool, falls),
        _names(
            "named_out",
            "a name or tag alone makes these solid actors no target",
            [target for target in evidence.targets if target.named_out],
            len(pool),
        ),
        _names(
            "hidden_solids",
            "these are walked on or around although no picture shows them",
            [target for target in evidence.targets if target.hidden and _carries_a_body(target)],
            0,
        ),
        _oversize(evidence),
        _switched_off(snapshot),
        _unknown(evidence),
    ]
    return [note for note in notes if note]


def _note(
    code: str, text: str, pool: Sequence[TargetRecord], falls: Sequence[Fall], rows: Collection[int]
) -> dict[str, Any]:
    """A note about targets, with approachability without them; empty where there are none."""
    if not rows:
        return {}
    note: dict[str, Any] = {"code": code, "text": text, "actors": [pool[row].name for row in sorted(rows)]}
    if falls and code != "buried_targets":
        share = approachable([fall for row, fall in enumerate(falls) if row not in rows])
        note["approachability_without"] = share
        told = "nothing is left" if share is None else f"approachability is {share:.3f}"
        note["text"] = f"{text}; without them {told}"
    return note


def _names(code: str, text: str, targets: Sequence[TargetRecord], pool: int) -> dict[str, Any]:
    if len(targets) <= NAMED_SHARE * pool:
        return {}
    return {"code": code, "text": text, "actors": [target.name for target in targets]}


def _hidden(pool: Sequence[TargetRecord]) -> set[int]:
    return {row for row, target in enumerate(pool) if target.hidden}


def _longest(target: TargetRecord) -> float:
    return max(high - low for low, high in zip(target.low_cm, target.high_cm, strict=True))


def _tiny(pool: Sequence[TargetRecord]) -> set[int]:
    return {row for row, target in enumerate(pool) if _longest(target) < TINY_CM}


def _giant(pool: Sequence[TargetRecord]) -> set[int]:
    return {row for row, target in enumerate(pool) if _longest(target) > GIANT_CM}


def _crowded(pool: Sequence[TargetRecord]) -> set[int]:
    """All but the first of each place, where that is most of them."""
    seen: set[tuple[int, ...]] = set()
    more: set[int] = set()
    for row, target in enumerate(pool):
        middle = [(low + high) / 2 for low, high in zip(target.low_cm, target.high_cm, strict=True)]
        place = tuple(round(part / PLACE_CM) for part in middle)
        if place in seen:
            more.add(row)
        seen.add(place)
    return more if len(more) > CROWD_SHARE * len(pool) else set()


def _undermined(evidence: NavigationEvidence, pool: Sequence[TargetRecord], falls: Sequence[Fall]) -> dict[str, Any]:
    """Scenery that stands on a floor of its own: nobody can stand near it there, but somebody can far below."""
    floors = [target for target in evidence.targets if target.left == "surface" or _is_wide(target)]
    rows = [
        row
        for row, (target, fall) in enumerate(zip(pool, falls, strict=False))
        if fall == "raised" and any(_carries(floor, target) for floor in floors if floor.index != target.index)
    ]
    if not rows:
        return {}
    counted: list[Fall] = ["unreached" if row in set(rows) else fall for row, fall in enumerate(falls)]
    share = approachable(counted)
    text = (
        "these stand on a floor, yet the only walkable area near them is more than 150 cm below, so they count as "
        f"scenery; a floor under the floor takes them out of the pool; with them approachability is {share or 0.0:.3f}"
    )
    names = [pool[row].name for row in rows]
    return {"code": "raised_targets", "text": text, "actors": names, "approachability_with": share}


def _carries_a_body(target: TargetRecord) -> bool:
    """Whether a body may stand on it, as on a hidden slope to what is out of reach."""
    wide = min(high - low for low, high in zip(target.low_cm[:2], target.high_cm[:2], strict=True))
    return target.left == "surface" or (not target.left and wide >= 2 * AGENT_RADIUS_CM)


def _is_wide(target: TargetRecord) -> bool:
    return min(high - low for low, high in zip(target.low_cm[:2], target.high_cm[:2], strict=True)) >= FLOOR_CM


def _carries(floor: TargetRecord, target: TargetRecord) -> bool:
    middle = [(low + high) / 2 for low, high in zip(target.low_cm[:2], target.high_cm[:2], strict=True)]
    over = all(low <= part <= high for low, part, high in zip(floor.low_cm[:2], middle, floor.high_cm[:2], strict=True))
    return over and abs(target.low_cm[2] - floor.high_cm[2]) <= BELOW_CM


def _oversize(evidence: NavigationEvidence) -> dict[str, Any]:
    named = [
        target.name
        for target in evidence.targets
        if max(target.high_cm[0] - target.low_cm[0], target.high_cm[1] - target.low_cm[1]) > PLATE_CM
        or target.high_cm[2] - target.low_cm[2] > TOWER_CM
    ]
    text = "wider than 200 m or higher than 50 m: a part that large does not widen the navigation bounds"
    return {"code": "left_out_of_bounds", "text": text, "actors": named} if named else {}


def _switched_off(snapshot: Mapping[str, Any]) -> dict[str, Any]:
    bodied = bodied_meshes(snapshot)
    actors = [actor for actor in snapshot.get("actors") or [] if isinstance(actor, Mapping)]
    named = [str(actor.get("name")) for actor in actors if is_switched_off(actor, bodied)]
    text = (
        f"their collision is switched off although their meshes have bodies: {len(named)} actors are no targets, and a "
        "body walks through them"
    )
    return {"code": "collision_switched_off", "text": text, "actors": named} if named else {}


def _unknown(evidence: NavigationEvidence) -> dict[str, Any]:
    text = "their collision is not known: they bar no way, and count by their pivots"
    return {"code": "collision_unknown", "text": text, "actors": sorted(evidence.unknown)} if evidence.unknown else {}
