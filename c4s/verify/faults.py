"""What a verdict says of requests to a model that failed for good and were accepted at the run's word."""

from __future__ import annotations

from typing import Any, Final

from c4s.records.judgement import Judgements
from c4s.records.verdict import Verdict

ACCEPTED: Final = "accepted_faults"
"""Code of the advisory."""


def accepted_faults(judgements: Judgements) -> list[dict[str, Any]]:
    """An advisory where claims or calls were lost to faults; they are worth 0, and the score says less than it
    could."""
    lost = judgements.accepted_faults
    if not lost:
        return []
    what = f"{len(lost)} request{'' if len(lost) == 1 else 's'} to the judge's model failed"
    return [{"code": ACCEPTED, "text": f"{what} and count as errors, worth 0; the first: {lost[0]}", "actors": []}]


def holds_accepted_faults(verdict: Verdict) -> bool:
    """Whether a verdict was made of judgements with such requests: it holds for the run that accepts them."""
    return any(advisory.get("code") == ACCEPTED for advisory in verdict.advisories)
