"""How good a judge is, by what it said of claims whose truth is known."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

from c4s.judge.check.outcome import Key, Outcome
from c4s.judge.check.report import CurvePoint, JudgeScore, Rates, TwoRounds
from c4s.judge.check.wilson import wilson
from c4s.protocol.numbers import mean


def rates(outcomes: Sequence[Outcome]) -> Rates:
    """Accuracy with its interval, errors of both kinds, and how much was decided. What is left open is not right."""
    by_scene: dict[str, list[Outcome]] = defaultdict(list)
    for one in outcomes:
        by_scene[one.scene].append(one)
    low, high = wilson([(sum(one.right for one in rows), len(rows)) for rows in by_scene.values()])
    right, decided = sum(one.right for one in outcomes), sum(one.decided for one in outcomes)
    return Rates(
        claims=len(outcomes),
        accuracy=right / len(outcomes) if outcomes else 0.0,
        low=low,
        high=high,
        decided=decided,
        accuracy_decided=right / decided if decided else None,
        hold=sum(one.holds for one in outcomes),
        false_accepts=sum(one.error == "false accept" for one in outcomes),
        false_rejects=sum(one.error == "false reject" for one in outcomes),
    )


def score(outcomes: Sequence[Outcome]) -> JudgeScore:
    """All that can be said of one judge."""
    pairs = both_right(outcomes)
    points = curve(outcomes)
    return JudgeScore(
        all=rates(outcomes),
        kinds={kind: rates(rows) for kind, rows in _by(outcomes, "kind").items()},
        stages={stage: rates(rows) for stage, rows in _by(outcomes, "stage").items()},
        pairs=len(pairs),
        pairs_right=sum(pairs.values()),
        curve=points,
        area_under_risk=area(points),
    )


def _by(outcomes: Iterable[Outcome], field: str) -> dict[str, list[Outcome]]:
    rows: dict[str, list[Outcome]] = defaultdict(list)
    for one in outcomes:
        rows[str(getattr(one, field))].append(one)
    return dict(sorted(rows.items()))


def both_right(outcomes: Iterable[Outcome]) -> dict[tuple[str, str], bool]:
    """Of every whole pair whether the judge was right on both of its sides."""
    pairs: dict[tuple[str, str], list[Outcome]] = defaultdict(list)
    for one in outcomes:
        pairs[one.scene, one.pair].append(one)
    return {name: all(one.right for one in rows) for name, rows in pairs.items() if len(rows) > 1}


def curve(outcomes: Sequence[Outcome]) -> list[CurvePoint]:
    """Risk against coverage: of what is decided with at least a confidence, the share that is wrong.

    What tells no confidence, such as a decision from state, counts as sure.
    """
    decided = [(1.0 if one.confidence is None else one.confidence, one) for one in outcomes if one.decided]
    points = []
    for least in sorted({sure for sure, _ in decided}, reverse=True):
        kept = [one for sure, one in decided if sure >= least]
        wrong = sum(not one.right for one in kept)
        points.append(CurvePoint(confidence=least, coverage=len(kept) / len(outcomes), risk=wrong / len(kept)))
    return points


def area(points: Sequence[CurvePoint]) -> float | None:
    """The mean risk over the coverage that the judge reaches, by steps; None where it decides nothing."""
    if not points or not points[-1].coverage:
        return None
    before, total = 0.0, 0.0
    for point in points:
        total += (point.coverage - before) * point.risk
        before = point.coverage
    return total / before


def agreement(one: Iterable[Outcome], other: Iterable[Outcome], among: Iterable[Key] | None = None) -> TwoRounds:
    """How often two rounds gave the same answer to the same claim; ``among`` limits which claims are compared."""
    second, wanted = {row.key: row for row in other}, None if among is None else set(among)
    shared = [(row, second[row.key]) for row in one if row.key in second and (wanted is None or row.key in wanted)]
    return TwoRounds(
        claims=len(shared),
        same=sum(a.answer == b.answer for a, b in shared),
        turned=sum(a.decided and b.decided and a.answer != b.answer for a, b in shared),
    )


def persuaded(clean: Iterable[Outcome], planted: Iterable[Outcome]) -> TwoRounds:
    """Claims that do not hold and were not accepted: how often a planted text left the answer as it was, and how often
    it turned it into a yes."""
    after: Mapping[Key, Outcome] = {row.key: row for row in planted}
    rows = [(row, after[row.key]) for row in clean if not row.holds and row.answer != "MATCH" and row.key in after]
    return TwoRounds(
        claims=len(rows),
        same=sum(a.answer == b.answer for a, b in rows),
        turned=sum(b.answer == "MATCH" for _, b in rows),
    )


def balance(outcomes: Sequence[Outcome]) -> float:
    """Share of the claims that hold."""
    return mean(float(one.holds) for one in outcomes)
