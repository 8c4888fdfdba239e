"""What looks wrong in a scene to somebody without sight: guesses at repairs from the actor list alone.

Three signs are used, each strong enough that an untouched scene rarely shows it:

* a copy: an actor of the same mesh as another, far closer to it than their own size, overlapping it;
* an odd size: one actor of a group of at least four equal meshes whose scale differs while all others agree;
* a mirrored one: a negative scale where the others of its mesh have none.

Moves, turns, removals and replacements leave no such sign and are not guessed at.
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

LEAST_GROUP = 4
COPY_DISTANCE_CM = 60.0
SAME_SCALE = 0.01

Actor = Mapping[str, Any]


@dataclass(frozen=True)
class Mend:
    """One repair: delete an actor, or give it another scale."""

    actor: str
    scale: tuple[float, float, float] | None
    """None deletes the actor."""
    reason: str


def mends(actors: Sequence[Actor]) -> list[Mend]:
    """Repairs in a fixed order; an actor gets at most one."""
    groups: dict[tuple[str, ...], list[Actor]] = defaultdict(list)
    for actor in actors:
        if actor["static_meshes"]:
            groups[tuple(actor["static_meshes"])].append(actor)
    found: dict[str, Mend] = {}
    for members in groups.values():
        for mend in [*_copies(members), *_odd_scales(members)]:
            found.setdefault(mend.actor, mend)
    return sorted(found.values(), key=lambda mend: mend.actor)


def _copies(members: Sequence[Actor]) -> list[Mend]:
    """The later of two actors of one mesh that stand almost in the same place."""
    found = []
    for index, actor in enumerate(members):
        for earlier in members[:index]:
            distance = math.dist(actor["location"], earlier["location"])
            if 0 < distance < COPY_DISTANCE_CM and _typical_distance(members) > 3 * distance:
                found.append(Mend(actor["name"], None, f"stands {distance:.0f} cm from its like {earlier['label']}"))
                break
    return found


def _typical_distance(members: Sequence[Actor]) -> float:
    """Median distance of an actor to the nearest of its like."""
    nearest = sorted(
        min((math.dist(a["location"], b["location"]) for b in members if b is not a), default=math.inf) for a in members
    )
    return nearest[len(nearest) // 2]


def _odd_scales(members: Sequence[Actor]) -> list[Mend]:
    if len(members) < LEAST_GROUP:
        return []
    usual, count = Counter(tuple(round(s, 3) for s in actor["scale"]) for actor in members).most_common(1)[0]
    if count < len(members) - 1:
        return []
    wanted = (float(usual[0]), float(usual[1]), float(usual[2]))
    return [
        Mend(actor["name"], wanted, f"scale {list(actor['scale'])} while its {count} like have {list(usual)}")
        for actor in members
        if max(abs(a - b) for a, b in zip(actor["scale"], usual, strict=True)) > SAME_SCALE
    ]
