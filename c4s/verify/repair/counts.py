"""From correspondence and acceptance to true positives, false positives and false negatives (paper, equation of the
repair counts; scorer facts 2.6 and 2.7)."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.protocol.repair import NOMINAL, Tolerances
from c4s.verify.actors.kinds import Kinds
from c4s.verify.repair.acceptance import Errors, measure
from c4s.verify.repair.actors import Actor, by_identity, prepare, scene_actors
from c4s.verify.repair.assignment import minimum_cost
from c4s.verify.repair.correspondence import Correspondence, Pair, correspond
from c4s.verify.repair.targets import RepairTarget, find_targets


@dataclass(slots=True)
class Repair:
    """All of a case that does not depend on the tolerance profile."""

    targets: list[RepairTarget]
    beside: list[str]
    """Labels of actors that differ from the truth in properties which make no target."""
    start: list[Actor]
    candidate: list[Actor]
    matched: Correspondence
    pool: list[int]
    """C: candidate actors that are new, changed, or stand for an actor to be restored; in canonical order."""
    start_of: dict[int, Pair]
    """Pair of each matched candidate actor."""
    output_of: dict[int, int]
    """Candidate actor of each matched input actor."""
    target_of_start: dict[int, RepairTarget]
    start_index: dict[str, int]
    """Index of an input actor by identity."""
    replaced: set[int]
    """Input actors whose candidate actor is of another kind."""
    measured: dict[tuple[int, int], Errors] = field(default_factory=dict)
    solved: dict[bytes, list[tuple[int, int]]] = field(default_factory=dict)
    """Measurements and assignments that the tolerance profiles share."""

    def errors(self, target: int, candidate: int) -> Errors:
        """Measured errors of a candidate actor against a desired-present target, both by index."""
        if (target, candidate) not in self.measured:
            truth = self.targets[target].truth
            assert truth is not None
            self.measured[target, candidate] = measure(truth, self.candidate[candidate].record)
        return self.measured[target, candidate]

    def assignment(self, cost: NDArray[np.float64]) -> list[tuple[int, int]]:
        """Minimum-cost pairs of a table of targets and candidate pool."""
        table = cost.tobytes()
        if table not in self.solved:
            self.solved[table] = minimum_cost(cost)
        return self.solved[table]


@dataclass(frozen=True, slots=True)
class RepairResult:
    """Counts and scores of one case under one tolerance profile, with what explains them.

    Attributes:
        accepted: index of a target to index of the candidate actor that satisfies it.
        removed_targets: indices of removal targets that succeeded.
        losses: input actors of the background that were lost or repurposed (o).
        rebounds: index of a repair target, and of the removal target whose actor was reused for it.
    """

    case: Repair
    tolerances: Tolerances
    tp: int
    fp: int
    fn: int
    accepted: dict[int, int]
    removed_targets: frozenset[int]
    losses: tuple[int, ...]
    repurposed: frozenset[int]
    rebounds: tuple[tuple[int, int], ...]

    @property
    def rebound(self) -> int:
        """Removal targets whose actor was reused for a repair target."""
        return len(self.rebounds)

    @property
    def precision(self) -> float:
        """TP / (TP + FP); 0 when nothing was counted."""
        return self.tp / (self.tp + self.fp) if self.tp + self.fp else 0.0

    @property
    def recall(self) -> float:
        """TP / (TP + FN); targets are never empty."""
        return self.tp / (self.tp + self.fn)

    @property
    def f1(self) -> float:
        """2 TP / (2 TP + FP + FN)."""
        return 2 * self.tp / (2 * self.tp + self.fp + self.fn)


def prepare_case(start: Any, truth: Any, candidate: Any) -> Repair:
    """Targets, correspondence and candidate pool of a case. Raises ``BadInput`` for scenes that cannot be scored."""
    start_entries, truth_entries = scene_actors(start, "input"), scene_actors(truth, "truth")
    candidate_entries = scene_actors(candidate, "candidate")
    kinds = Kinds()
    start_by_key = by_identity(start_entries, "input")
    before = prepare(start_entries, start_by_key, list(map(kinds.of, start_entries)))
    targets, beside = find_targets(
        start_by_key, by_identity(truth_entries, "truth"), {actor.key for actor in before if actor.location is not None}
    )
    candidate_kinds = list(map(kinds.of, candidate_entries))
    outputs = [entry for entry, kind in zip(candidate_entries, candidate_kinds, strict=True) if kind.semantic]
    after = prepare(outputs, by_identity(outputs, "candidate"), [kind for kind in candidate_kinds if kind.semantic])
    index_of = {actor.key: actor.index for actor in before}
    target_of_start = {index_of[t.key]: t for t in targets if t.operation != "add" and t.key in index_of}
    matched = correspond(before, after, set(target_of_start))
    start_of = {pair.candidate: pair for pair in matched.pairs}
    restored = {s for s, t in target_of_start.items() if t.operation == "repair"}
    pool = matched.new + [p.candidate for p in matched.pairs if p.fields or p.start in restored]
    _in_canonical_order(pool, before, after, matched, set(target_of_start))
    replaced = {
        p.start
        for p in matched.pairs
        if p.method == "pose_anchored_asset_change" and before[p.start].descriptor != after[p.candidate].descriptor
    }
    return Repair(
        targets,
        beside,
        before,
        after,
        matched,
        pool,
        start_of,
        {pair.start: pair.candidate for pair in matched.pairs},
        target_of_start,
        index_of,
        replaced,
    )


def _in_canonical_order(
    pool: list[int], before: list[Actor], after: list[Actor], matched: Correspondence, target_starts: set[int]
) -> None:
    """Sort the pool by content. Among equal contents the published order decides which one stands for a target: new
    actors by identity, then matched ones by phase and by the order in which each phase finds them."""
    pool.sort(key=lambda c: after[c].order())
    if len({after[c].order()[0] for c in pool}) == len(pool):
        return
    pair_of = {pair.candidate: pair for pair in matched.pairs}
    sizes = [Counter(actor.kind.number for actor in side) for side in (before, after)]

    def place(c: int) -> tuple[Any, ...]:
        actor, pair = after[c], pair_of.get(c)
        if pair is None:
            return actor.order()[0], 0, actor.key
        start, kind = before[pair.start], actor.kind.number
        if pair.method == "changed_structural_assignment":
            by_row = sizes[0][kind] <= sizes[1][kind]
            return actor.order()[0], 2, (start if by_row else actor).order()
        return (
            actor.order()[0],
            1 if pair.method == "unchanged_semantic" else 3,
            (pair.start in target_starts, *start.order()),
        )

    pool.sort(key=place)


def _accepted(case: Repair, limits: Tolerances) -> dict[int, int]:
    """One-to-one matching of desired-present targets to the pool with the most passing pairs."""
    present = [i for i, t in enumerate(case.targets) if t.truth is not None]
    if not present or not case.pool:
        return {}
    kinds: dict[Any, list[int]] = {}
    for column, c in enumerate(case.pool):
        kinds.setdefault(case.candidate[c].descriptor, []).append(column)
    cost = np.ones((len(present), len(case.pool)))
    for row, i in enumerate(present):
        for column in kinds.get(case.targets[i].descriptor, ()):
            if case.errors(i, case.pool[column]).accepted(limits):
                cost[row, column] = 0.0
    return {present[row]: case.pool[column] for row, column in case.assignment(cost) if cost[row, column] == 0.0}


def count(case: Repair, limits: Tolerances = NOMINAL) -> RepairResult:
    """Counts of a prepared case under a tolerance profile."""
    accepted = _accepted(case, limits)
    start_index, lost = case.start_index, set(case.matched.lost)
    rebounds = []
    for i, c in accepted.items():
        target = case.targets[i]
        own = start_index.get(target.key) if target.operation == "repair" else None
        pair = case.start_of.get(c)
        if target.operation != "repair" or pair is None or not (own is None or own in lost):
            continue
        other = case.target_of_start.get(pair.start)
        if other is not None and other.operation == "remove" and pair.start not in lost:
            lost -= {own}
            lost.add(pair.start)
            rebounds.append((i, case.targets.index(other)))
    done = frozenset(
        i
        for i, t in enumerate(case.targets)
        if t.operation == "remove" and start_index.get(t.key) in lost | case.replaced
    )
    repurposed = {
        pair.start
        for c in accepted.values()
        if (pair := case.start_of.get(c)) is not None and pair.start not in case.target_of_start
    }
    losses = sorted((lost - set(case.target_of_start)) | repurposed)
    m, d = len(accepted), len(done)
    return RepairResult(
        case,
        limits,
        m + d,
        len(case.pool) - m + len(losses),
        len(case.targets) - m - d,
        accepted,
        done,
        tuple(losses),
        frozenset(repurposed),
        tuple(rebounds),
    )


def repair(start: Any, truth: Any, candidate: Any, profile: Tolerances = NOMINAL) -> RepairResult:
    """Actor Repair F1 of a candidate scene.

    Args:
        start: snapshot of the corrupted scene that the agent was given.
        truth: snapshot of the original scene.
        candidate: snapshot of the saved scene.
        profile: acceptance limits.

    Raises:
        BadInput: a scene that cannot be scored, or no target at all.
    """
    return count(prepare_case(start, truth, candidate), profile)
