"""Which of many made cases are good ones: their truth loses nothing, and no guess without a picture repairs anything.

A case that is made by chance may have a truth that its own scene costs points for (a chair that stands in a table's leg
as its maker left it), and a change that stands out in the scene's numbers. Such a case is refused with the number, and
another is taken in its place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from c4s.packs.store import PackStore
from c4s.protocol.settings import Setting
from c4s.records.level import Level
from cases.admissible import Refusal, score_refusals
from cases.audit import audit_repair
from cases.boxes import Boxes


@dataclass(frozen=True)
class MadeCase:
    """A made case before its pictures: its levels and what a clean engine exports of them."""

    case_id: str
    setting: Setting
    start: Level
    input_snapshot: Mapping[str, Any]
    truth_snapshot: Mapping[str, Any]


def refusal_of(case: MadeCase, boxes: Boxes, store: PackStore) -> Refusal | None:
    """Why a case is not a good one, with the number; None where its truth scores fully and it gives nothing away."""
    for refusal in score_refusals(case.case_id, case.setting, case.truth_snapshot, case.input_snapshot, store, {}):
        return refusal
    way, f1 = audit_repair(case.case_id, case.start, case.input_snapshot, case.truth_snapshot, boxes).best
    if f1 > 0:
        return Refusal(case.case_id, "guessed", f"{way!r} repairs it without a look at a picture (F1 {f1:.2f})")
    return None


def sifted(
    candidates: Iterator[MadeCase], boxes: Boxes, store: PackStore, most: int, progress: Callable[[str], None]
) -> tuple[list[str], list[Refusal]]:
    """The first ``most`` good ones, by id, and those that were refused before that many were found."""
    good, refused = list[str](), list[Refusal]()
    for case in candidates:
        refusal = refusal_of(case, boxes, store)
        if refusal is None:
            good.append(case.case_id)
        else:
            refused.append(refusal)
            progress(f"  {case.case_id} is refused: {refusal.reason}")
        if len(good) == most:
            break
    return good, refused
