"""Which of many made cases are good ones: their truth loses nothing, and no guess without a picture repairs anything.

A case that is made by chance may have a truth that its own scene costs points for (a chair that stands in a table's leg
as its maker left it), and a change that stands out in the scene's numbers. Such a case is refused with the number, and
another is taken in its place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from c4s.packs.store import PackStore
from c4s.protocol.settings import Setting
from c4s.records.level import Level
from c4s.verify.repair import repair_verdict
from cases.admissible import Refusal
from cases.audit import audit_repair
from cases.boxes import Boxes
from cases.losses import loss_line, losses_of

WHOLE = 1.0 - 1e-9
MOST_TOLD = 3


@dataclass(frozen=True)
class MadeCase:
    """A made case before its pictures: its levels and what a clean engine exports of them."""

    case_id: str
    setting: Setting
    start: Level
    input_snapshot: Mapping[str, Any]
    truth_snapshot: Mapping[str, Any]


def fault_of(case: MadeCase, boxes: Boxes, store: PackStore) -> str | None:
    """Why a case is not a good one, with the number.

    ``None`` where its truth scores fully and it gives nothing away.
    """
    physics, losses = losses_of(case.setting, case.truth_snapshot, case.input_snapshot, store)
    if physics is None or physics < WHOLE:
        score = "not measured" if physics is None else f"{physics:.3f}"
        told = [loss_line(row) for row in losses] or ["physics scores nothing of what it changes"]
        more = f" and {len(told) - MOST_TOLD} more" if len(told) > MOST_TOLD else ""
        return f"its truth has a physics score of {score}: {'; '.join(told[:MOST_TOLD])}{more}"
    repair = repair_verdict(case.input_snapshot, case.truth_snapshot, case.truth_snapshot)
    if (repair.score or 0.0) < WHOLE:
        return f"its truth has a Repair F1 of {repair.score or 0.0:.3f}"
    way, f1 = audit_repair(case.case_id, case.start, case.input_snapshot, case.truth_snapshot, boxes).best
    if f1 > 0:
        return f"{way!r} repairs it without a look at a picture (F1 {f1:.2f})"
    return None


def sifted(
    candidates: Iterator[MadeCase], boxes: Boxes, store: PackStore, most: int, progress: Callable[[str], None]
) -> tuple[list[str], list[Refusal]]:
    """The first ``most`` good ones, by id, and those that were refused before that many were found."""
    good, refused = list[str](), list[Refusal]()
    for case in candidates:
        reason = fault_of(case, boxes, store)
        if reason is None:
            good.append(case.case_id)
        else:
            refused.append(Refusal(case.case_id, reason))
            progress(f"  {case.case_id} is refused: {reason}")
        if len(good) == most:
            break
    return good, refused


def summed(refused: Sequence[Refusal]) -> str:
    """What was refused in one line: how many for which reason."""
    physics = sum("a physics score" in one.reason for one in refused)
    blind = sum("without a look" in one.reason for one in refused)
    seen = sum("of 1280x720" in one.reason for one in refused)
    rest = len(refused) - physics - blind - seen
    told = [
        (physics, "lose physics"),
        (blind, "can be guessed"),
        (seen, "cannot be seen"),
        (rest, "cannot be repaired fully"),
    ]
    return ", ".join(f"{count} {what}" for count, what in told if count)
