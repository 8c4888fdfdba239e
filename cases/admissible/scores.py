"""Whether a perfect repair and none at all are worth what they should be, by the published rules."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.packs.store import PackStore
from c4s.protocol.case import i2s_case
from c4s.protocol.settings import Setting
from c4s.verify.repair import repair_verdict
from cases.admissible.refusal import Refusal
from cases.losses import Row, loss_line, losses_of

NOTHING = 0.2
"""Score of a submission that changes nothing: no target, and nothing that it did is physically wrong."""
_MOST_TOLD = 3


def score_refusals(
    case_id: str,
    setting: Setting,
    truth: Mapping[str, Any],
    start: Mapping[str, Any],
    store: PackStore,
    names: Mapping[str, str],
) -> list[Refusal]:
    """Reasons against a repair of which a perfect one is not worth exactly 1, or none not exactly 0.2.

    Args:
        case_id, setting: of the case.
        truth, start: what a clean engine exported of the two levels.
        store: the packs of the scene.
        names: what the author calls the actors of both levels.
    """
    physics, losses = losses_of(setting, truth, start, store)
    if physics != 1.0:
        score = "not measured" if physics is None else f"{physics:.3f}"
        told = [loss_line(_named(row, names)) for row in losses] or ["physics scores nothing of what it changes"]
        more = f" and {len(told) - _MOST_TOLD} more" if len(told) > _MOST_TOLD else ""
        reason = f"its truth has a physics score of {score}: {'; '.join(told[:_MOST_TOLD])}{more}"
        return [Refusal(case_id, "loses", reason)]
    repair = repair_verdict(start, truth, truth).score or 0.0
    if repair != 1.0:
        return [Refusal(case_id, "unreachable", f"its truth has a Repair F1 of {repair:.3f}")]
    idle = repair_verdict(start, truth, start).score or 0.0
    worth = i2s_case(valid=True, repair_f1=idle, physics=losses_of(setting, start, start, store)[0])["score"]
    if worth != NOTHING:
        return [
            Refusal(case_id, "unreachable", f"doing nothing scores {worth:.6g} and not {NOTHING:g} (F1 {idle:.3f})")
        ]
    return []


def _named(row: Row, names: Mapping[str, str]) -> Row:
    return {key: names.get(value, value) if key in ("actor", "partner") else value for key, value in row.items()}
