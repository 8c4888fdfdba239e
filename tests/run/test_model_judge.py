"""A run with a model judge, on an endpoint over HTTP: pending while it fails, then scored from what was done."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from c4s.files import read_json
from c4s.records.folder import RunFolder
from c4s.records.judgement import Judgements
from c4s.records.plan import Plan
from c4s.run.stages import ATTEMPTS
from tests.judge.judge_endpoint import Body, JudgeEndpoint, Sent, Truth, claims_in, purpose_of
from tests.run.conftest import Command, apart, trial_in
from warehouse.database import rows

CASE = "text-flat-family"
RUN = ("run", "small", "-a", "oracle", "-c", CASE, "--run-id", "seen")


class EveryClaim(dict[str, bool]):
    """Every requirement is met."""

    def get(self, text: str, default: object = None) -> bool:  # type: ignore[override]
        """Met."""
        return True


TRUE = Truth(EveryClaim())


@pytest.fixture(scope="module")
def own(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home where nothing else runs, with the file of a judge."""
    made = apart(tmp_path_factory.mktemp("judged") / "home", home)
    (made / "judge.yaml").write_text(yaml.safe_dump({"name": "seer", "model": "m", "claims_per_request": 4}))
    return made


@pytest.fixture(scope="module")
def endpoint(own: Path) -> Iterator[JudgeEndpoint]:
    """The judge's model; its address is in the home's endpoints, not in the judge's file."""
    with JudgeEndpoint(TRUE) as opened:
        row = {"url": opened.url, "formats": ["openai-chat"]}
        (own / "endpoints.yaml").write_text(yaml.safe_dump({"endpoints": {"judge": row}}))
        yield opened


def failing(body: Body) -> Sent:
    """Claims are answered, the overview is not."""
    return TRUE(body) if purpose_of(body) == "sight" else Sent(b'{"error": "gone"}', 404)


def test_a_run_is_judged_by_a_model_of_a_file(own: Path, endpoint: JudgeEndpoint, c4s: Command) -> None:
    judge = ("--judge", str(own / "judge.yaml"))
    endpoint.answer = failing
    done = c4s(*RUN, *judge, home=own)
    trial = trial_in(own, "seen", "oracle", CASE)
    assert done.returncode == 3 and "1 of 1 trials are pending" in done.stderr and "404" in done.stderr
    assert not trial.judgements("seer").exists() and not trial.verdict("detailed").exists()
    assert (trial.attempt(1).done, trial.verdict("physics").is_file()) == (True, True)
    asked = endpoint.purposes()["sight"]
    outcome = trial.attempt(1).outcome.read_bytes()

    endpoint.answer = TRUE
    done = c4s(*RUN, *judge, "--judge-tokens", "1000000", "--json", home=own)
    assert done.returncode == 0, done.stderr
    assert trial.attempt(1).outcome.read_bytes() == outcome and endpoint.purposes()["sight"] == asked
    said = Judgements.read(trial.judgements("seer"))
    plan = Plan.read(own / "runs/seen/plan.json")
    assert (said.judge, said.kind, said.judge_version) == ("seer", "model", plan.judge_version)
    assert plan.judge_configuration.model == "m" and endpoint.url not in (own / "runs/seen/plan.json").read_text()
    assert said.usage is not None and said.usage.cached == asked and len(said.schedule) == asked + 2
    assert {claim.stage for claim in said.claims} >= {"state", "sight"}
    assert read_json(trial.verdict("detailed"))["measurements"]["judge_version"] == plan.judge_version
    assert read_json(trial.verdict("overview"))["score"] == 1.0
    assert RunFolder(own / "runs/seen").judging.is_file()
    stored = {path.stem for path in trial.exchanges("seer").glob("*.json")}
    assert {row.request_sha256 for row in said.schedule} <= stored
    found = {path.read_bytes() for path in trial.root.rglob("*") if path.is_file()}
    assert not any(endpoint.url.encode() in data for data in found)

    (own / "judge.yaml").write_text((own / "judge.yaml").read_text() + "seed: 7\n")
    other = c4s(*RUN, *judge, home=own)
    assert other.returncode == 2 and "another version of its judge" in other.stderr
    for attempt in range(2, ATTEMPTS + 1):
        assert not trial.attempt(attempt).done


def test_faults_are_accepted_when_asked_and_the_judges_are_not_ranked_together(
    own: Path, endpoint: JudgeEndpoint, c4s: Command
) -> None:
    def answer(body: Body) -> Sent:
        lost = purpose_of(body) == "sight" and any(row["kind"] == "scene identity" for row in claims_in(body))
        return Sent(b'{"error": "gone"}', 404) if lost else TRUE(body)

    endpoint.answer = answer
    done = c4s(*RUN[:-1], "accepted", "--judge", str(own / "judge.yaml"), "--accept-faults", home=own)
    assert done.returncode == 0, done.stderr
    verdict = read_json(trial_in(own, "accepted", "oracle", CASE).verdict("detailed"))
    assert verdict["population"]["errors"] > 0 and verdict["advisories"][0]["code"] == "accepted_faults"
    said = rows(own / "warehouse", "SELECT detail FROM findings WHERE run_id = 'seen' AND verifier = 'detailed'")
    assert {"seen (overview-1, confidence 0.90)", "placed"} <= {row["detail"] for row in said}
    found = rows(own / "warehouse", "SELECT judge, judge_version, planned FROM leaderboards WHERE suite = 'small'")
    assert len({row["judge_version"] for row in found}) == len(found) == 2
    assert {(row["judge"], row["planned"]) for row in found} == {("seer", 1)}
    boards = (own / "site/index.html").read_text().split('<section class="board"')[1:]
    links = [set(re.findall(r'href="((?:boards|agents)/[^"]+)"', board)) for board in boards]
    assert len(links) == 2 and not links[0] & links[1], "each leaderboard has pages of its own"
    for board, pages in zip(boards, links, strict=True):
        version = re.findall(r'title="version ([^"]+)"', board)[0]
        assert len(pages) == 3 and all(version in (own / "site" / page).read_text() for page in pages)


def test_a_limit_in_dollars_without_a_price_is_refused_before_anything_runs(
    own: Path, endpoint: JudgeEndpoint, c4s: Command
) -> None:
    (own / "dear.yaml").write_text(yaml.safe_dump({"name": "dear", "model": "m"}))
    asked = (*RUN[:-1], "priced", "--judge", str(own / "dear.yaml"), "--judge-spend", "1")
    done = c4s(*asked, home=own)
    assert done.returncode == 2 and "no price for model 'm'" in done.stderr
    (own / "prices.yaml").write_text("prices: [{model: m, input: 1, output: 5}]")
    done = c4s(*asked, home=own)
    (own / "prices.yaml").unlink()
    assert done.returncode == 2 and "prices.0.from" in done.stderr
    assert not (own / "runs/priced/plan.json").exists()

    again = c4s(*RUN[:-1], "accepted", "--judge", str(own / "judge.yaml"), "--accept-faults", home=own)
    assert "1 trial is done and reused" in again.stdout, "what this run accepted is done"
    strict = (*RUN[:-1], "strict", "--judge", str(own / "judge.yaml"))
    done = c4s(*strict, home=own)
    assert done.returncode == 3 and "404" in done.stderr, "no other run takes it over"
    endpoint.answer = TRUE
    done = c4s(*strict, home=own)
    assert done.returncode == 0, done.stderr
    verdict = read_json(trial_in(own, "strict", "oracle", CASE).verdict("detailed"))
    assert "errors" not in verdict["population"] and not verdict["advisories"]
    other = c4s(*RUN[:-1], "another", "--judge", str(own / "judge.yaml"), home=own)
    assert "reused from run 'strict'" in other.stdout


def test_a_judge_without_an_endpoint_is_refused_before_anything_runs(own: Path, tmp_path: Path, c4s: Command) -> None:
    bare = apart(tmp_path / "home", own)
    done = c4s(*RUN, "--judge", "qwen3.8-27b", home=bare)
    assert done.returncode == 2 and "C4S_JUDGE_URL" in done.stderr
    assert not (bare / "runs/seen/plan.json").exists()
