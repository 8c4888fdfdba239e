"""The two semantic verdicts of a scene, by the rule judge."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.judge.rule.judging import judge_by_rule
from c4s.records.verdict import Verdict
from c4s.verify.semantic import detailed, overview

Record = Mapping[str, Any]


def verify_detailed(bundle: Any, snapshot: Record, catalog: Record, captures: Record | None = None) -> Verdict:
    """Detailed Alignment of a scene by a bundle."""
    return detailed.verify_detailed(bundle, judge_by_rule(bundle, "", snapshot, catalog, captures))


def verify_overview(asked: Any, snapshot: Record, catalog: Record, captures: Record | None = None) -> Verdict:
    """Overview Alignment of a scene by a bundle, or by a bare prompt."""
    bundle, prompt = (None, asked) if isinstance(asked, str) else (asked, "")
    return overview.verify_overview(judge_by_rule(bundle, prompt, snapshot, catalog, captures))


def verify_both(
    bundle: Any, snapshot: Record, catalog: Record, captures: Record | None = None
) -> tuple[Verdict, Verdict]:
    """Detailed and Overview Alignment of a scene by a bundle, of one judging."""
    judgements = judge_by_rule(bundle, "", snapshot, catalog, captures)
    return detailed.verify_detailed(bundle, judgements), overview.verify_overview(judgements)
