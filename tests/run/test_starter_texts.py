"""The starter texts by the rule judge: authors above planner above every cheat, and nothing false of the authors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from c4s.protocol.baselines import CHEATS, ORACLE
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.judgement import Judgements
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.records.verdict import Verdict
from tests.run.conftest import apart, command_in
from tests.starter import demo_trial, starter_home

TEXTS = ("text-flat-family", "text-harbour-street", "text-office-open-plan", "text-small-farm")
PLANNER, MARGIN = "planner", 0.1
STRONG = ("once", "parade")
"""Cheats that come nearest to the planner; the others, far below, are held on the smallest text."""
AUTHORS = (ORACLE, PLANNER)
EVERYWHERE = (*AUTHORS, *STRONG)
OTHERS = tuple(cheat for cheat in CHEATS if cheat not in STRONG)
SMALLEST = TEXTS[0]
RUN, WEAK_RUN = "texts", "weak"
pytestmark = pytest.mark.timeout(1500)


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home in which the agents have done their texts; those that the demo has done are read there."""
    own = apart(tmp_path_factory.mktemp("texts") / "home", starter_home(tmp_path_factory))
    shown = all(demo_trial(agent, text) for agent in AUTHORS for text in TEXTS)
    for run, agents, texts in ((RUN, STRONG if shown else EVERYWHERE, TEXTS), (WEAK_RUN, OTHERS, (SMALLEST,))):
        chosen = [part for agent in agents for part in ("-a", agent)] + [part for one in texts for part in ("-c", one)]
        done = command_in(own)("run", "starter", *chosen, "--run-id", run, timeout=900)
        assert done.returncode == 0, done.stdout + done.stderr
    return own


def trial(home: Path, agent: str, case_id: str) -> TrialFolder:
    alias = SuiteFolder(home / "suites/starter").case(case_id).alias
    own = RunFolder(home / "runs" / (WEAK_RUN if agent in OTHERS else RUN)).trial(agent, alias, 1)
    return own if own.root.is_dir() else _of_demo(agent, case_id)


def _of_demo(agent: str, case_id: str) -> TrialFolder:
    found = demo_trial(agent, case_id)
    assert found is not None
    return found


def score(home: Path, agent: str, case_id: str) -> float:
    found = TrialScore.read(trial(home, agent, case_id).score).score
    assert found is not None
    return found


@pytest.mark.parametrize("case_id", TEXTS)
def test_authors_are_above_the_planner_and_the_planner_above_every_cheat(ran: Path, case_id: str) -> None:
    done = (*EVERYWHERE, *OTHERS) if case_id == SMALLEST else EVERYWHERE
    scores = {agent: score(ran, agent, case_id) for agent in done}
    told = json.dumps(scores, indent=1)
    assert scores[ORACLE] >= scores[PLANNER] + MARGIN, told
    assert all(scores[PLANNER] >= scores[cheat] + MARGIN for cheat in scores if cheat in CHEATS), told


@pytest.mark.parametrize("case_id", TEXTS)
def test_of_the_authors_scene_nothing_is_said_not_to_hold(ran: Path, case_id: str) -> None:
    said = Judgements.read(trial(ran, ORACLE, case_id).judgements("rule"))
    assert said.claims
    assert [claim.claim for claim in said.claims if claim.answer == "MISMATCH"] == []


@pytest.mark.parametrize(("cheat", "code"), [("buried", "supported_below_ground"), ("ghost", "collision_switched_off")])
def test_a_population_that_shrinks_is_told(ran: Path, cheat: str, code: str) -> None:
    advisories: list[dict[str, Any]] = Verdict.read(trial(ran, cheat, SMALLEST).verdict("physics")).advisories
    assert code in {advisory["code"] for advisory in advisories}
