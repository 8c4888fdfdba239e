"""Whether the rates of a scene were lifted by things that only stand clear."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np

from c4s.verify.actors.roles import bounds_of, is_non_solid
from c4s.verify.physics.scene import actor_name

LEAST_FILLERS: Final = 20
"""Fewer things dilute nothing worth telling."""
MOST_COMPARED: Final = 5000
"""Larger scenes are not compared box by box for an advisory."""
APART_CM: Final = 30.0


def diluted(
    actors: Sequence[Mapping[str, Any]], scored: Sequence[int], violators: Sequence[int], floating: Sequence[str]
) -> list[dict[str, Any]]:
    """Solids apart from the group with most faults, or copies of the commonest asset, where they are at least half of
    all tested ones and have fewer faults than the rest. A group is what stands within 30 cm of one another, floors too.
    """
    faulty = {actor_name(actors[i]) for i in violators} | set(floating)
    if not faulty or len(scored) < LEAST_FILLERS or len(actors) > MOST_COMPARED:
        return []
    fillers = _copies(actors, scored) | (_apart(actors, faulty) & set(scored))
    rest = [i for i in scored if i not in fillers]
    if not rest or len(fillers) < max(LEAST_FILLERS, len(rest)):
        return []
    of_fillers, of_rest = (sum(actor_name(actors[i]) in faulty for i in group) for group in (fillers, rest))
    if of_fillers * len(rest) >= of_rest * len(fillers):
        return []
    text = (
        f"{len(fillers)} of {len(scored)} tested solids stand apart or are copies of one asset, and have fewer faults "
        "than the rest: both rates rise with every thing that stands clear"
    )
    return [{"code": "diluted_population", "text": text, "actors": [actor_name(actors[i]) for i in sorted(fillers)]}]


def _copies(actors: Sequence[Mapping[str, Any]], scored: Sequence[int]) -> set[int]:
    """The copies of one asset, where they are at least half."""
    assets = [str(actors[i].get("asset_path") or "") for i in scored]
    asset, count = Counter(assets).most_common(1)[0]
    return {i for i, one in zip(scored, assets, strict=True) if one == asset} if 2 * count >= len(scored) else set()


def _apart(actors: Sequence[Mapping[str, Any]], faulty: set[str]) -> set[int]:
    """Solid actors outside the group that has most faults, or most members of those."""
    solid = {i: box for i, actor in enumerate(actors) if not is_non_solid(actor) and (box := bounds_of(actor))}
    if not solid:
        return set()
    origin, half = (np.array([box[part] for box in solid.values()]).reshape(-1, 3) for part in (0, 1))
    low, high = origin - half - APART_CM, origin + half
    group = np.full(len(solid), -1)
    for first in range(len(solid)):
        waiting = [first] if group[first] < 0 else []
        while waiting:
            row = waiting.pop()
            near = ((low <= high[row]) & (high >= low[row])).all(axis=1)
            found = np.flatnonzero(near & (group < 0))
            group[found] = first
            waiting += found.tolist()
    marked = np.array([actor_name(actors[i]) in faulty for i in solid])
    faults, sizes = np.bincount(group, marked), np.bincount(group)
    scene = max(range(len(sizes)), key=lambda one: (faults[one], sizes[one]))
    return {i for i, one in zip(solid, group, strict=True) if one != scene}
