"""Which candidate actor is which input actor, without names or ids (paper, "Matching actors across input and
generated scenes"; scorer fact 2.5).

Three phases: unchanged actors, then leftovers of one descriptor at minimum cost, then leftovers of one class at one
pose (an asset swapped or a mesh cleared in place). Actors of a phase are taken in the order of their canonical content,
so the order of the export does not matter; that order is only computed where there is a choice.
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Callable, Hashable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain, product
from typing import Literal, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from c4s.geometry.transform import quat_from_rotator
from c4s.protocol.repair import ANGLE_COST, FIELD_COST, GUARD, SAME_LOCATION_CM, SAME_ROTATION_DEG, SAME_SCALE
from c4s.verify.actors.difference import changed_fields, property_differences, transform_differences
from c4s.verify.repair.actors import Actor
from c4s.verify.repair.assignment import maximum_matching, minimum_cost

Method: TypeAlias = Literal["unchanged_semantic", "changed_structural_assignment", "pose_anchored_asset_change"]
_CELL_CM = 50.0
"""Edge of the hash cells: far above the 0.1 cm reach, so that nearly every lookup is in one cell."""
_STACK = 8
"""Actors at one point from which verdicts on equal contents are remembered."""
_REACH_CM = SAME_LOCATION_CM * (1 + 1e-9)
_FAR_CELL = 2**40
_MIX = np.array([0x1F35_9A3B, 0x2545_F491_4F6C_DD1D, 0x0CE6_6D5B_97A1_2F33, 0x3C79_AC49_2BA7_B653])
"""Odd factors that turn kind and cell into one number. Where two cells meet in a number their actors are many, which
only means that they are looked at one by one."""
_PROPERTY_FIELDS = (
    "class",
    "asset_path",
    "component_asset_paths",
    "material_paths",
    "component_material_slots",
    "properties",
)


class Pair(msgspec.Struct, frozen=True, gc=False):
    """An input actor and its candidate actor, by index; ``fields`` are those that changed."""

    start: int
    candidate: int
    method: Method
    fields: tuple[str, ...]


@dataclass(slots=True)
class Correspondence:
    """The pairs, and what is left on either side."""

    pairs: list[Pair] = field(default_factory=list)
    lost: list[int] = field(default_factory=list)
    """Input actors without a candidate actor."""
    new: list[int] = field(default_factory=list)
    """Candidate actors without an input actor."""


def _near(
    actors: Iterable[Actor], others: Iterable[Actor], key: Callable[[Actor], Hashable]
) -> Iterator[tuple[Actor, list[Actor]]]:
    """Each posed actor that has them, with the posed others of the same key within 0.1 cm on every axis.

    Actors of one key at one point share one list where it is long.
    """
    cells: dict[Hashable, list[Actor]] = defaultdict(list)
    for other, cell in zip(*_cells(others, 0.0), strict=True):
        cells[key(other), *cell].append(other)
    posed, low = _cells(actors, -_REACH_CM)
    _, high = _cells(posed, _REACH_CM)
    at_point: dict[Hashable, list[Actor]] = {}
    for actor, first, last in zip(posed, low, high, strict=True):
        kind, (x, y, z) = key(actor), actor.location or (0.0, 0.0, 0.0)
        if (known := at_point.get((kind, x, y, z))) is not None:
            yield actor, known
            continue
        if first == last:
            inside = cells.get((kind, *first))
        else:
            inside = [
                other
                for cell in product(*(sorted({a, b}) for a, b in zip(first, last, strict=True)))
                for other in cells.get((kind, *cell), ())
            ]
        if inside:
            close = [
                other
                for other in inside
                if (at := other.location) is not None
                and abs(at[0] - x) <= _REACH_CM
                and abs(at[1] - y) <= _REACH_CM
                and abs(at[2] - z) <= _REACH_CM
            ]
            if close:
                if len(close) >= _STACK:
                    at_point[kind, x, y, z] = close
                yield actor, close


def _posed(actors: Iterable[Actor]) -> tuple[list[Actor], NDArray[np.float64]]:
    """The posed actors and their locations (n, 3) in cm."""
    posed = [actor for actor in actors if actor.location is not None]
    numbers = chain.from_iterable([actor.location or () for actor in posed])
    return posed, np.fromiter(numbers, float, 3 * len(posed)).reshape(-1, 3)


def _cells(actors: Iterable[Actor], shift_cm: float) -> tuple[list[Actor], list[list[float]]]:
    """The posed actors, and the hash cell of each one's location shifted along every axis."""
    posed, places = _posed(actors)
    cells: list[list[float]] = np.floor((places + shift_cm) / _CELL_CM).tolist()
    return posed, cells


def _lonely(start: list[Actor], candidate: list[Actor]) -> Iterator[tuple[Actor, Actor]]:
    """Pairs of one kind within 0.1 cm on every axis that have no other actor of their kind within reach.

    Nearly all of a large scene: told by counting the actors of each hash cell, without a look at single ones. An actor
    whose reach crosses the border of its cell is left out, and so are all in a cell of more than two.
    """
    (left, left_places), (right, right_places) = _posed(start), _posed(candidate)
    if not left or not right:
        return
    places = np.vstack([left_places, right_places])
    cell = np.floor(places / _CELL_CM)
    inner = (
        (np.floor((places - _REACH_CM) / _CELL_CM) == cell)
        & (np.floor((places + _REACH_CM) / _CELL_CM) == cell)
        & (np.abs(cell) < _FAR_CELL)
    ).all(axis=1)
    kinds = np.fromiter([actor.kind.number for side in (left, right) for actor in side], np.int64)
    mixed = np.column_stack([kinds, np.clip(cell, -_FAR_CELL, _FAR_CELL).astype(np.int64)]) @ _MIX
    _, bucket = np.unique(mixed, return_inverse=True)
    here, there = bucket[: len(left)], bucket[len(left) :]
    sizes = [np.bincount(side, minlength=len(bucket)) for side in (here, there)]
    owner = np.zeros(len(bucket), dtype=np.intp)
    owner[there] = np.arange(len(right))
    i = np.nonzero(inner[: len(left)] & (sizes[0][here] == 1) & (sizes[1][here] == 1))[0]
    j = owner[here[i]]
    near = inner[len(left) + j] & (np.abs(left_places[i] - right_places[j]) <= _REACH_CM).all(axis=1)
    yield from zip(map(left.__getitem__, i[near].tolist()), map(right.__getitem__, j[near].tolist()), strict=True)


class _Matcher:
    def __init__(self, start: list[Actor], candidate: list[Actor], target_starts: set[int]) -> None:
        self.start, self.candidate, self.targets = start, candidate, target_starts
        self.open_start = dict.fromkeys(range(len(start)))
        self.open_candidate = dict.fromkeys(range(len(candidate)))
        self.pairs: list[Pair] = []

    def take_lonely(self) -> None:
        """The unchanged actors without a rival on either side: the only pair that each can be in."""
        self.pairs = [
            Pair(actor.index, other.index, "unchanged_semantic", ())
            for actor, other in _lonely(self.start, self.candidate)
            if (actor.written is not None and actor.written == other.written) or unchanged(actor, other)
        ]
        starts, candidates = {pair.start for pair in self.pairs}, {pair.candidate for pair in self.pairs}
        self.open_start = {s: None for s in self.open_start if s not in starts}
        self.open_candidate = {c: None for c in self.open_candidate if c not in candidates}

    def take(self, start: int, candidate: int, method: Method, fields: tuple[str, ...]) -> None:
        self.pairs.append(Pair(start, candidate, method, fields))
        del self.open_start[start], self.open_candidate[candidate]

    def near_edges(
        self, key: Callable[[Actor], Hashable], accept: Callable[[Actor, Actor], bool]
    ) -> dict[int, list[int]]:
        """Acceptable pairs at one place among what is open: indices of candidates by index of the input actor."""
        near = _near((self.start[s] for s in self.open_start), (self.candidate[c] for c in self.open_candidate), key)
        known: dict[tuple[str, str], bool] = {}
        stacks: dict[tuple[int, str], tuple[list[Actor], list[int]]] = {}

        def accepted(actor: Actor, other: Actor) -> bool:
            contents = actor.order()[0], other.order()[0]
            if contents not in known:
                known[contents] = accept(actor, other)
            return known[contents]

        def of_stack(actor: Actor, others: list[Actor]) -> list[int]:
            """The same list for actors of one content at one point."""
            place = id(others), actor.order()[0]
            if place not in stacks:
                stacks[place] = others, [other.index for other in others if accepted(actor, other)]
            return stacks[place][1]

        return {
            actor.index: of_stack(actor, others)
            if len(others) >= _STACK
            else [other.index for other in others if accept(actor, other)]
            for actor, others in near
        }

    def match(self, edges: dict[int, list[int]], method: Method) -> None:
        """Maximum matching over ``edges``: background first, then targets on what is left."""
        lists = {id(options): options for options in edges.values()}
        times = Counter(map(id, edges.values()))
        degree: dict[int, int] = defaultdict(int)
        for number, options in lists.items():
            for c in options:
                degree[c] += times[number]
        contested = []
        for s, options in edges.items():
            if len(options) == 1 and degree[options[0]] == 1:
                self.take(s, options[0], method, self.fields(s, options[0], method))
            elif options:
                contested.append(s)
        contested.sort(key=lambda s: self.start[s].order())
        open_lists = {id(edges[s]): edges[s] for s in contested}
        choices = sorted(
            {c for options in open_lists.values() for c in options}, key=lambda c: self.candidate[c].order()
        )
        rank = {c: place for place, c in enumerate(choices)}
        ranked = {number: sorted(options, key=rank.__getitem__) for number, options in open_lists.items()}
        ordered = {s: ranked[id(edges[s])] for s in contested}
        background = maximum_matching([s for s in contested if s not in self.targets], ordered.__getitem__)
        targets = maximum_matching(
            [s for s in contested if s in self.targets], ordered.__getitem__, {c: s for s, c in background.items()}
        )
        for s, c in (background | targets).items():
            self.take(s, c, method, self.fields(s, c, method))

    def fields(self, s: int, c: int, method: Method) -> tuple[str, ...]:
        if method == "unchanged_semantic":
            return ()
        return tuple(changed_fields(self.start[s].record, self.candidate[c].record))

    def assign_leftovers(self) -> None:
        """Minimum-cost pairs among leftovers of one descriptor."""
        starts: dict[Hashable, list[Actor]] = defaultdict(list)
        candidates: dict[Hashable, list[Actor]] = defaultdict(list)
        for s in self.open_start:
            starts[self.start[s].kind.number].append(self.start[s])
        for c in self.open_candidate:
            candidates[self.candidate[c].kind.number].append(self.candidate[c])
        for kind, left in starts.items():
            right = candidates.get(kind)
            if not right:
                continue
            left.sort(key=Actor.order)
            right.sort(key=Actor.order)
            method: Method = "changed_structural_assignment"
            for i, j in [(0, 0)] if len(left) == len(right) == 1 else minimum_cost(_costs(left, right)):
                self.take(left[i].index, right[j].index, method, self.fields(left[i].index, right[j].index, method))


def unchanged(start: Actor, candidate: Actor) -> bool:
    """Whether the candidate actor reproduces every recorded field of the input actor (scorer fact 2.3)."""
    return start.entry.alike(candidate.entry) or not changed_fields(start.record, candidate.record)


def _classes(actors: list[Actor]) -> tuple[NDArray[np.int64], list[Actor]]:
    """The number of each actor's class, and an actor of each: equal in all that a cost depends on but the location."""
    known: dict[str, int] = {}
    members: list[Actor] = []
    numbers = []
    for actor in actors:
        posed = actor.vector("rotation_deg"), actor.vector("scale"), actor.location is None
        content = repr((posed, [actor.record.get(name, "<absent>") for name in _PROPERTY_FIELDS]))
        if content not in known:
            known[content] = len(known)
            members.append(actor)
        numbers.append(known[content])
    return np.array(numbers, np.int64), members


def _vectors(actors: list[Actor], member: str) -> NDArray[np.float64]:
    """A vector of every actor (n, 3), NaN where it is not known."""
    return np.array([actor.vector(member) or (math.nan,) * 3 for actor in actors], dtype=float).reshape(-1, 3)


def _turns(actors: list[Actor]) -> NDArray[np.float64]:
    """The quaternion of every actor (n, 4), NaN where its rotation is not known."""
    unknown = (math.nan,) * 4
    turns = [actor.vector("rotation_deg") for actor in actors]
    return np.array([unknown if turn is None else quat_from_rotator(turn) for turn in turns], dtype=float)


def _costs(left: list[Actor], right: list[Actor]) -> NDArray[np.float64]:
    """Cost of every pair: ``d/(1+d) + 0.2*angle/180 + 0.05*changed fields``; unknown place 1, unknown turn 0.2.

    Equal costs are frequent and the solver settles them by place, so the numbers are the published ones bit by bit.
    What does not depend on the location is worked out once a pair of distinct contents.
    """
    from c4s.verify.repair import compiled

    (left_class, left_members), (right_class, right_members) = _classes(left), _classes(right)
    angle = compiled.angles(_turns(left_members), _turns(right_members))
    fields = np.array(
        [[len(property_differences(a.record, b.record, target=False)) for b in right_members] for a in left_members],
        dtype=float,
    )
    stretched = np.zeros(fields.shape, bool)
    for a, b in zip(_vectors(left_members, "scale").T, _vectors(right_members, "scale").T, strict=True):
        stretched |= np.abs(a[:, None] - b[None, :]) > SAME_SCALE
    fields += angle > SAME_ROTATION_DEG + GUARD
    fields += stretched
    cost = compiled.costs(
        _vectors(left, "location_cm"),
        _vectors(right, "location_cm"),
        left_class,
        right_class,
        np.where(np.isnan(angle), 1.0, angle / 180),
        fields,
        SAME_LOCATION_CM,
        ANGLE_COST,
        FIELD_COST,
    )
    lost = [[number for number, actor in enumerate(side) if actor.location is None] for side in (left, right)]
    for i, j in {*product(lost[0], range(len(right))), *product(range(len(left)), lost[1])}:
        turned = angle[left_class[i], right_class[j]]
        distance = compiled.distances(_vectors([left[i]], "location_cm"), _vectors([right[j]], "location_cm"))[0, 0]
        placed = 1.0 if math.isnan(distance) else distance / (1 + distance)
        posed = placed + ANGLE_COST * (1.0 if math.isnan(turned) else turned / 180)
        cost[i, j] = posed + FIELD_COST * len(changed_fields(left[i].record, right[j].record))
    return cost


def correspond(start: list[Actor], candidate: list[Actor], target_starts: set[int]) -> Correspondence:
    """Match input and candidate actors. ``target_starts`` are the input actors that are repair or removal targets."""
    matcher = _Matcher(start, candidate, target_starts)
    matcher.take_lonely()
    matcher.match(matcher.near_edges(lambda actor: actor.kind.number, unchanged), "unchanged_semantic")
    matcher.assign_leftovers()
    if matcher.open_start and matcher.open_candidate:
        matcher.match(
            matcher.near_edges(
                lambda a: a.descriptor[0],
                lambda a, b: not transform_differences(a.record, b.record, as_quaternion=True),
            ),
            "pose_anchored_asset_change",
        )
    return Correspondence(matcher.pairs, list(matcher.open_start), list(matcher.open_candidate))
