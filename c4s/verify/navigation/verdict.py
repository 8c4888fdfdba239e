"""The Embodied Utility Score of a scene from what was measured of it (paper, eq. eus-a, eus-w, eus).

A scene that could not be measured has no number and says why. That is neither a zero nor a finding against the scene:
only the conservative mean of a study lets it count 0. Order of the rules: E03 of the readings.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from c4s.navigation import agree, approachable, judge_walk
from c4s.navigation.selection import half_extent_cm
from c4s.protocol.navigation import EXCLUDED, LEAST_POOL, NAVIGATION_POLICY, Withheld, arrival_radius_cm
from c4s.records.navigation import LETTERS, SCENERY, Fall, NavigationEvidence, TargetRecord, WalkRecord
from c4s.records.verdict import Verdict
from c4s.stats.navigation import utility
from c4s.verify.navigation.advisories import advisories_of

NAME = "navigation"
REQUIRED = ("radius_cm", "height_cm", "slope_deg", "min_region_area")
"""Settings that the mesh must be known to have had (EU13)."""
_REASONS: dict[Withheld, str] = {
    "not_probed": "no navigation mesh of this engine was probed",
    "navigation_too_large": "the navigation mesh would be too large",
    "not_settled": "the navigation mesh did not settle",
    "settings_not_kept": "the navigation mesh did not keep its settings",
    "not_certified": "no two builds in a row of the navigation mesh agree",
    "no_anchor": "no member of the largest component is near the ground: there is nowhere to start a walk",
    "no_route": "there is no route that is long enough to walk",
    "content_failure": "content of the scene is not here: its collision is not known",
}


def verify_navigation(evidence: NavigationEvidence | None, snapshot: Mapping[str, Any]) -> Verdict:
    """The verdict; without evidence it is not evaluated."""
    if evidence is None:
        return _withheld("not_probed", {}, "", [])
    pool = [target for target in evidence.targets if not target.left]
    made = _settings(evidence)
    notes = advisories_of(evidence, snapshot, pool)
    reason, detail = _unreliable(evidence, pool)
    if reason is not None:
        return _withheld(reason, made | _share_alone(evidence), detail, notes)
    falls = _falls(evidence)
    floor = [fall for fall in falls if fall not in SCENERY]
    share = approachable(falls)
    made |= {"approachability": share, "targets": Counter(falls), "picture": _picture(evidence, pool, falls)}
    population = {"actors": len(evidence.targets), "pool": len(pool), "floor_level": len(floor)}
    if len(floor) < LEAST_POOL or not share:
        rule = "small_pool" if len(floor) < LEAST_POOL else "nothing_approachable"
        return _measured(0.0, made | {"zero_rule": rule}, population, notes)
    assert evidence.bounds_cm is not None
    half = half_extent_cm((np.array(evidence.bounds_cm[0]), np.array(evidence.bounds_cm[1])))
    radius = arrival_radius_cm(half)
    made |= {"half_extent_cm": round(half, 2), "arrival_radius_cm": round(radius, 2)}
    if not evidence.walks:
        missing = not evidence.small and evidence.anchor_cm is None
        return _withheld("no_anchor" if missing else "no_route", made, "", notes, population)
    walks = [_walk(one, radius) for one in evidence.walks]
    arrived = sum(walk["arrived"] for walk in walks)
    population |= {"walks": len(walks), "arrived": arrived}
    made |= {"completion": arrived / len(walks), "walks": walks}
    return _measured(utility(share, arrived, len(walks)), made, population, notes)


def _settings(evidence: NavigationEvidence) -> dict[str, Any]:
    return {
        "engine": evidence.engine,
        "made_by": evidence.made_by,
        "settings": evidence.kept,
        "builds": [build.plain() for build in evidence.builds],
        "bounds_cm": evidence.bounds_cm,
    }


def _share_alone(evidence: NavigationEvidence) -> dict[str, Any]:
    """A of the benchmark's own probe, which tells no more than that; nothing of other measurements."""
    if evidence.made_by != "published_probe" or evidence.fault is not None:
        return {}
    falls = _falls(evidence)
    return {"approachability": approachable(falls), "targets": Counter(falls)}


def _unreliable(evidence: NavigationEvidence, pool: Sequence[TargetRecord]) -> tuple[Withheld | None, str]:
    """Why the measurement says nothing, and the detail; None where it does."""
    if evidence.fault is not None:
        return evidence.fault, evidence.detail
    if evidence.made_by == "walkable_space" and evidence.unknown and len(evidence.unknown) >= len(pool):
        return "content_failure", next(iter(evidence.unknown.values()))
    needed = {name: evidence.asked.get(name) for name in REQUIRED}
    wrong = [name for name, value in needed.items() if value is None or not _same(evidence.kept.get(name), value)]
    if wrong:
        return "settings_not_kept", ", ".join(wrong)
    if len(evidence.builds) < 2 or not agree(*evidence.builds[-2:]):
        return "not_certified", f"{len(evidence.builds)} builds"
    return None, ""


def _same(kept: float | None, asked: float) -> bool:
    return kept is not None and abs(kept - asked) <= 1e-3


def _falls(evidence: NavigationEvidence) -> list[Fall]:
    """Of the later of the two builds that agree (E07)."""
    return [LETTERS[letter] for letter in evidence.builds[-1].falls]


def _walk(one: WalkRecord, radius: float) -> dict[str, Any]:
    walk = judge_walk(np.array(one.trace_cm), np.array(one.left_cm), np.array(one.goal_cm), radius)
    return {
        "start": one.start,
        "goal": one.goal,
        "length_cm": one.length_cm,
        "seconds": walk.seconds,
        "arrived": walk.arrived,
        "stalled": walk.stalled,
        "short_cm": round(walk.short_cm, 1),
    }


def _picture(evidence: NavigationEvidence, pool: Sequence[TargetRecord], falls: Sequence[Fall]) -> dict[str, Any]:
    """What a map of the walks is drawn from: whole centimetres."""
    return {
        "map": None if evidence.map is None else evidence.map.plain(),
        "floors": None if evidence.floors is None else evidence.floors.plain(),
        "anchor": None if evidence.anchor_cm is None else [round(part) for part in evidence.anchor_cm],
        "targets": [
            [
                target.label or target.name,
                fall,
                *(round(part) for part in (*target.low_cm[:2], *target.high_cm[:2], target.low_cm[2])),
            ]
            for target, fall in zip(pool, falls, strict=True)
        ],
        "routes": [[[round(part) for part in point] for point in walk.route_cm] for walk in evidence.walks],
        "traces": [[[round(part) for part in point] for point in walk.trace_cm] for walk in evidence.walks],
    }


def _measured(score: float, made: dict[str, Any], population: dict[str, int], notes: list[dict[str, Any]]) -> Verdict:
    return Verdict(
        verifier=NAME,
        status="measured",
        score=score,
        policy=NAVIGATION_POLICY,
        measurements=made,
        population=population,
        advisories=notes,
    )


def _withheld(
    reason: Withheld,
    made: dict[str, Any],
    detail: str,
    notes: list[dict[str, Any]],
    population: dict[str, int] | None = None,
) -> Verdict:
    """No number, and why. ``excluded``: it is not the scene's doing, and the record counts nowhere."""
    text = _REASONS[reason]
    return Verdict(
        verifier=NAME,
        status="not_evaluated",
        policy=NAVIGATION_POLICY,
        measurements={**made, "reason_code": reason, "excluded": reason in EXCLUDED},
        population=population or {},
        advisories=notes,
        reason=f"{text}: {detail}" if detail else text,
    )
