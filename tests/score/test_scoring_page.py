"""``docs/scoring.md`` lists what the code has: advisories, policies, kinds of rows, policy ids."""

from __future__ import annotations

import re
from collections.abc import Iterable
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
WALKS = (ROOT / "docs" / "embodied-utility.md").read_text(encoding="utf-8")
RAISED = re.compile(r"""(?:"code":\s*|_(?:advisory|note|names)\(\s*)"([\w-]+)\"""")
WALK_ROOM = ROOT / "c4s" / "verify" / "navigation"


def _raised(paths: Iterable[Path]) -> set[str]:
    return {code for path in paths for code in RAISED.findall(path.read_text(encoding="utf-8"))}


def _listed(section: str) -> list[str]:
    return sorted(re.findall(r"^\| `([\w-]+)` \|", section, flags=re.MULTILINE))


def test_every_advisory_is_explained_and_none_is_left_over() -> None:
    paths = [path for folder in ("verify", "score", "judge") for path in (ROOT / "c4s" / folder).rglob("*.py")]
    raised = {*_raised(path for path in paths if not path.is_relative_to(WALK_ROOM)), ACCEPTED}
    assert len(raised) > 10 and _listed(PAGE.split("## Advisories")[1]) == sorted(raised)


def test_every_advisory_of_walks_is_explained_and_none_is_left_over() -> None:
    raised = _raised(WALK_ROOM.rglob("*.py"))
    assert len(raised) > 5 and _listed(WALKS.split("## Cheats")[1]) == sorted(raised)


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
