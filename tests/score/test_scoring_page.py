"""``docs/scoring.md`` lists what the code has: advisories, policies, kinds of rows, policy ids."""

from __future__ import annotations

import re
from pathlib import Path

from c4s.protocol.repair import REPAIR_POLICY
from c4s.protocol.rules import (
    CASE_POLICY,
    I2S_FLOATING_METRIC,
    INTEGRITY_POLICY,
    MODEL_POLICY,
    NEAR_BODIES_METRIC,
    OVERVIEW_RULE_POLICY,
    PENETRATION_METRIC,
    PHYSICS_POLICY,
    ROLE_POLICY,
    SEMANTIC_CASE_POLICY,
    T2S_FLOATING_METRIC,
)
from c4s.score.batch import KINDS
from c4s.score.policies import POLICIES
from c4s.verify.faults import ACCEPTED

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "scoring.md").read_text(encoding="utf-8")
RAISED = re.compile(r"""(?:"code":\s*|_advisory\(\s*)"([\w-]+)\"""")


def test_every_advisory_is_explained_and_none_is_left_over() -> None:
    raised = {
        code
        for folder in ("verify", "score", "judge")
        for path in (ROOT / "c4s" / folder).rglob("*.py")
        for code in RAISED.findall(path.read_text(encoding="utf-8"))
    }
    raised.add(ACCEPTED)
    rows = re.findall(r"^\| (`[^|]*`) \|", PAGE.split("## Advisories")[1], flags=re.MULTILINE)
    listed = [code for row in rows for code in re.findall(r"`([\w-]+)`", row)]
    assert len(raised) > 10 and sorted(listed) == sorted(raised)


def test_every_id_is_on_the_page() -> None:
    ids = {
        *POLICIES,
        *KINDS,
        *CASE_POLICY.values(),
        MODEL_POLICY,
        PHYSICS_POLICY,
        SEMANTIC_CASE_POLICY,
        T2S_FLOATING_METRIC,
        INTEGRITY_POLICY,
        OVERVIEW_RULE_POLICY,
        REPAIR_POLICY,
        I2S_FLOATING_METRIC,
        NEAR_BODIES_METRIC,
        PENETRATION_METRIC,
        ROLE_POLICY,
    }
    assert [name for name in sorted(ids) if f"`{name}`" not in PAGE] == []
