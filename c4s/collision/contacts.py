"""Contacts between the actors of a scene, with their exact minimum-translation depth.

Broad phase: an STR tree over plan boxes, then height, then the push-out of the two boxes, which bounds the depth from
above. Narrow phase: ``c4s.collision.depth``. The depth of two actors is the largest depth of their convex bodies, which
is what an engine with separate shapes reports.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from c4s.bounds import BOUNDS
from c4s.collision.depth import BodyTable, DepthMeter, Pairs
from c4s.collision.mesh_body import Array
from c4s.collision.scene import SceneBodies, scene_bodies

__all__ = ["Contact", "ContactRule", "DepthMeter", "contacts", "scene_contacts"]

CHUNK = 1024
"""Bodies that are searched for partners at a time: bounds the memory of a crowded scene."""
MOST_PAIRS = 20_000
"""Pairs that are measured at a time: bounds the memory too."""
MOST_HITS = 4_000_000
"""Pairs of boxes that a search may find at a time, should all bodies lie at one point."""
ENOUGH = 24
"""Contacts beyond its limit that settle an actor: two settled actors are not measured against each other. Thousands of
actors at one point (a spawn loop gone wrong) would have millions of contacts."""


class Contact(NamedTuple):
    """Two actors that overlap. ``depth_cm`` is the minimum translation (cm) that separates their deepest bodies."""

    a: str
    """Object name of the actor that comes first in the snapshot."""
    b: str
    depth_cm: float
    trusted: bool
    """False when the touch or the depth could not be confirmed."""
    a_index: int = -1
    """Position of the actor in the snapshot."""
    b_index: int = -1


@dataclass(frozen=True)
class ContactRule:
    """What counts as a contact, by position of the actors (arrays of one length)."""

    limits_cm: Array
    """Depth in cm from which on a contact settles an actor."""
    solid: NDArray[np.bool_]
    """False for actors that nothing bumps into."""
    group: Pairs
    """Actors of one group (not negative) do not count against each other."""

    @classmethod
    def everything(cls, actors: int) -> ContactRule:
        """All contacts count, and none settles anything."""
        return cls(np.full(actors, math.inf), np.ones(actors, dtype=bool), np.full(actors, -1))

    def wanted(self, a: Pairs, b: Pairs, beyond: Pairs) -> NDArray[np.bool_]:
        """Which pairs of actors to measure, given how many contacts beyond its limit each actor has so far."""
        counts = self.solid[a] & self.solid[b] & ((self.group[a] < 0) | (self.group[a] != self.group[b]))
        return np.asarray(counts & ((beyond[a] < ENOUGH) | (beyond[b] < ENOUGH)))


def contacts(
    snapshot: Mapping[str, Any], *, minimum_depth_cm: float = 0.0, actors: Collection[str] | None = None
) -> list[Contact]:
    """Contacts deeper than ``minimum_depth_cm``, in snapshot order; ``actors``: only those of these object names."""
    chosen = None if actors is None else {i for i, name in enumerate(_names(snapshot)) if name in actors}
    return scene_contacts(snapshot, scene_bodies(snapshot), minimum_depth_cm=minimum_depth_cm, actors=chosen)


def scene_contacts(
    snapshot: Mapping[str, Any],
    scene: SceneBodies,
    *,
    minimum_depth_cm: float = 0.0,
    actors: Collection[int] | None = None,
    rule: ContactRule | None = None,
) -> list[Contact]:
    """``contacts`` for bodies that are already placed; ``actors``: only those at these positions.

    Two actors have one contact, of their deepest trusted pair of bodies; and a second one when a pair that is not
    trusted may be deeper.

    ``rule``: what counts. Without it every contact is found; with it those that do not count are left out, and those
    between two actors that both have ``ENOUGH`` trusted ones beyond their limits.

    Raises ``BadInput`` for a scene so crowded that it is beyond ``bodies``, ``box_pairs`` or ``measured_pairs``.
    """
    names = _names(snapshot)
    table = BodyTable(scene.bodies)
    owners = np.array(scene.owners, dtype=np.int64)
    rule = rule or ContactRule.everything(len(names))
    beyond = np.zeros(len(names), dtype=np.int64)
    parts = []
    measured = 0
    for i, j, push_out in _candidates(table, owners, minimum_depth_cm, actors):
        wanted = rule.wanted(owners[i], owners[j], beyond)
        i, j, push_out = i[wanted], j[wanted], push_out[wanted]
        measured += len(i)
        BOUNDS["measured_pairs"].hold(measured, where="contacts")
        depth, trusted = table.depths(i, j, push_out, minimum_depth_cm)
        hit = np.flatnonzero(depth > 0)
        part = _deepest(
            np.minimum(owners[i[hit]], owners[j[hit]]),
            np.maximum(owners[i[hit]], owners[j[hit]]),
            depth[hit],
            trusted[hit],
        )
        parts.append(part)
        for side in part[:2]:
            beyond += np.bincount(side[part[3] & (part[2] > rule.limits_cm[side])], minlength=len(beyond))
    if not parts:
        return []
    a, b, depth, trusted = _deepest(*(np.concatenate(column) for column in zip(*parts, strict=True)))
    return [
        Contact(names[one], names[other], cm, sure, one, other)
        for one, other, cm, sure in zip(a.tolist(), b.tolist(), depth.tolist(), trusted.tolist(), strict=True)
    ]


def _deepest(
    a: Pairs, b: Pairs, depth: Array, trusted: NDArray[np.bool_]
) -> tuple[Pairs, Pairs, Array, NDArray[np.bool_]]:
    """Of each pair (a, b): the deepest trusted row, then the deepest other row if that is deeper; sorted by pair."""
    order = np.lexsort((-depth, ~trusted, b, a))
    a, b, depth, trusted = a[order], b[order], depth[order], trusted[order]
    same = np.concatenate([[False], (a[1:] == a[:-1]) & (b[1:] == b[:-1])]) if len(a) else np.zeros(0, dtype=bool)
    again = same & np.concatenate([[False], trusted[1:] == trusted[:-1]]) if len(a) else same
    keep = np.flatnonzero(~again)
    a, b, depth, trusted, same = a[keep], b[keep], depth[keep], trusted[keep], same[keep]
    shallow = same.copy()
    shallow[1:] &= depth[1:] <= depth[:-1]
    keep = np.flatnonzero(~shallow)
    return a[keep], b[keep], depth[keep], trusted[keep]


def _names(snapshot: Mapping[str, Any]) -> list[str]:
    return [
        str(actor.get("name") or actor.get("label") or f"#{i}") for i, actor in enumerate(snapshot.get("actors") or [])
    ]


def _candidates(
    table: BodyTable, owners: Pairs, minimum_depth_cm: float, actors: Collection[int] | None
) -> Iterator[tuple[Pairs, Pairs, Array]]:
    """Body pairs of different actors whose boxes overlap by more than ``minimum_depth_cm``, with that push-out."""
    if len(owners) < 2:
        return
    low, high = table.low, table.high
    chosen = None if actors is None else np.isin(owners, np.fromiter(actors, dtype=np.int64, count=len(actors)))
    BOUNDS["bodies"].hold(len(owners), where="contacts")
    boxes = shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1])
    tree = shapely.STRtree(boxes)
    searching = np.argsort(table.rank)
    if chosen is not None:
        searching = searching[chosen[searching]]
    found: list[tuple[Pairs, Pairs, Array]] = []
    chunk, met = max(1, min(CHUNK, MOST_HITS // len(owners))), 0
    for start in range(0, len(searching), chunk):
        part = searching[start : start + chunk]
        hit, j = tree.query(boxes[part])
        met += len(hit)
        BOUNDS["box_pairs"].hold(met // 2, where="contacts")
        i = part[hit]
        keep = owners[i] != owners[j]
        keep &= (i < j) if chosen is None else ((i < j) | ~chosen[j])
        i, j = i[keep], j[keep]
        push_out = np.minimum(high[i] - low[j], high[j] - low[i]).min(axis=1)
        keep = push_out > minimum_depth_cm
        found.append((i[keep], j[keep], push_out[keep]))
        if sum(len(pairs) for pairs, _, _ in found) > MOST_PAIRS:
            yield from _portions(found)
            found = []
    if found:
        yield from _portions(found)


def _portions(found: Sequence[tuple[Pairs, Pairs, Array]]) -> Iterator[tuple[Pairs, Pairs, Array]]:
    i, j, push_out = (np.concatenate(column) for column in zip(*found, strict=True))
    for start in range(0, len(i), MOST_PAIRS):
        part = slice(start, start + MOST_PAIRS)
        yield i[part], j[part], push_out[part]
