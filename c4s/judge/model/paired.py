"""The model's part of the paired judgement of a repair: each pair of views in a request of its own."""

from __future__ import annotations

from functools import partial

from c4s.judge.model.clerk import Clerk
from c4s.judge.model.contract import paired_of_value
from c4s.judge.model.overview import ContractBroken, asked_twice, why_broken
from c4s.judge.model.requests import Request, Writer
from c4s.judge.model.schemas import paired_schema
from c4s.judge.model.sights import picture_of_bytes
from c4s.judge.paired.judging import measured, paired_of, view_of
from c4s.judge.paired.pairs import ViewPair, view_pairs
from c4s.records.evidence import Evidence
from c4s.records.judgement import Asked, PairedJudgement, PairedView


def judge_pairs(
    evidence: Evidence, writer: Writer, clerk: Clerk, *, accept_faults: bool
) -> tuple[PairedJudgement | None, str, list[Asked]]:
    """All pairs, by the model and by measures; None with the reason where there is no pair, and what was asked."""
    found, reason = view_pairs(evidence.json("captures"))
    if not found:
        return None, reason, []
    made = clerk.side_by_side([partial(_pair, evidence, pair, writer, clerk, accept_faults) for pair in found])
    judgement, reason = paired_of([view for view, _ in made])
    return judgement, reason, [asked for _, schedule in made for asked in schedule]


def _pair(
    evidence: Evidence, pair: ViewPair, writer: Writer, clerk: Clerk, accept_faults: bool
) -> tuple[PairedView, list[Asked]]:
    shown = [
        (str(view["name"]), picture_of_bytes(evidence.beside_captures(str(view["file"]))))
        for view in (pair.truth, pair.target)
    ]

    def make(again: str) -> Request:
        return writer.write(
            "paired",
            "paired",
            shown,
            before="The scene as it should be, then as it is:",
            after=again,
            schema=paired_schema(),
            again=bool(again),
        )

    said, schedule = asked_twice(clerk, make, paired_of_value)
    measures = measured(evidence, pair)
    if said is not None:
        return view_of(pair, measures, said[0], said[1]), schedule
    reason = why_broken(schedule)
    if not accept_faults:
        raise ContractBroken(f"no comparison: {reason}", todo="run the same command again, or with --accept-faults")
    return view_of(pair, measures, {}, f"error: {reason}"), schedule
