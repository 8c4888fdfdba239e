"""``c4s judge repeat`` and the flow on a real run of the suite ``small``, judged over HTTP by a model that wavers."""

from __future__ import annotations

import json
import subprocess
import sys
import threading
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

import pytest

from c4s.files import digest_bytes
from c4s.protocol.rules import FAMILY_WEIGHTS
from c4s.records.folder import RunFolder
from c4s.records.judgement import Judgements
from c4s.records.repeatability import COHORT, Repeatability
from tests.judge.judge_endpoint import Body, JudgeEndpoint, Sent, Truth, claims_in, purpose_of
from tests.run.conftest import Command, apart, environment, trial_in
from tests.run.test_evaluate import OFFLINE

CASE = "text-flat-family"
AGENTS = ("oracle", "noop")
JUDGE = "name: wavering\nkind: model\nmodel: m\nclaims_per_request: 2\n"
FLOW = """
import asyncio, json
from flows.repeatability import repeatability
print(json.dumps(asyncio.run(repeatability("small", repeats=3, agents=["oracle"]))))
"""


class Wavering:
    """Answers by the words of the claim, and the other way for one in three of them at every second asking."""

    def __init__(self) -> None:
        self._asked: Counter[str] = Counter()
        self._lock = threading.Lock()

    def __call__(self, body: Body) -> Sent:
        """One answer."""
        purpose = purpose_of(body)
        if purpose not in ("sight", "alternate", "arbitration"):
            return Truth({})(body)
        with self._lock:
            key = digest_bytes(json.dumps(body).encode())
            self._asked[key] += 1
            odd = self._asked[key] % 2 == 1
        place = {row["requirement"]: int(digest_bytes(row["requirement"].encode())[:4], 16) for row in claims_in(body)}
        return Truth(
            {text: (number % 3 > 0) if odd or number % 9 else number % 2 > 0 for text, number in place.items()}
        )(body)


def files(root: Path) -> dict[str, bytes]:
    """Every file below a trial."""
    return {str(path.relative_to(root)): path.read_bytes() for path in sorted(root.rglob("*")) if path.is_file()}


@pytest.mark.timeout(900)
def test_a_run_is_repeated_goes_on_and_is_never_changed(
    home: Path, tmp_path: Path, c4s: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = apart(tmp_path / "home", home)
    judge = tmp_path / "wavering.yaml"
    judge.write_text(JUDGE)
    chosen = [part for agent in AGENTS for part in ("-a", agent)]
    with JudgeEndpoint(Wavering()) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        ran = c4s("run", "small", *chosen, "-c", CASE, "--judge", str(judge), home=own)
        assert ran.returncode == 0, ran.stderr
        run = RunFolder(own / "runs" / "small")
        trials = [trial_in(own, "small", agent, CASE) for agent in AGENTS]
        before = {trial.root: files(trial.root) for trial in trials}
        planned = len(Judgements.read(trials[0].judgements("wavering")).claim_schedule())
        endpoint.bodies.clear()

        done = c4s("judge", "repeat", "small", "--repeats", "2", "--json", home=own)
        assert done.returncode == 0, done.stderr
        found = json.loads(done.stdout)
        assert len(endpoint.bodies) == 2 * planned and endpoint.purposes().keys() <= {
            "sight",
            "alternate",
            "arbitration",
        }
        assert (found["requests_per_repeat"], found["evaluations"], found["repeats"]) == (planned, 4, 2)
        assert "1 of 2: repeat 1 of oracle" in done.stderr and "2 of 2: repeat 2" in done.stderr
        assert found["family_weights"] == FAMILY_WEIGHTS and found["cohort"] == COHORT
        assert [served["models"] for served in found["served"]] == [["m"], ["m"]]
        assert {trial.root: files(trial.root) for trial in trials} == before

        study = run.repeats(found["study"])
        endpoint.bodies.clear()
        more = c4s("judge", "repeat", "small", "--repeats", "3", home=own)
        assert more.returncode == 0 and len(endpoint.bodies) == planned, more.stderr
        assert "2 of 3 are there already" in more.stderr and "tau-b" in more.stdout and COHORT in more.stdout
        whole = Repeatability.read(study.record)
        check(whole, study.root)
        assert all(one.scores[:2] == old["scores"] for one, old in zip(whole.scenes, found["scenes"], strict=True))

        study.repeat(Path("oracle", trials[0].root.parent.name, "r1"), 2).unlink()
        endpoint.bodies.clear()
        assert c4s("judge", "repeat", "small", home=own).returncode == 0
        assert len(endpoint.bodies) == planned and Repeatability.read(study.record).repeats == 3

        flow = subprocess.run(
            [sys.executable, "-c", FLOW],
            env=environment(own) | OFFLINE | {"PREFECT_HOME": str(tmp_path / "prefect")},
            capture_output=True,
            text=True,
            check=False,
        )
        assert flow.returncode == 0, flow.stderr[-3000:]
        told = json.loads(flow.stdout.splitlines()[-1])
        assert [row["configuration"] for row in told["configurations"]] == ["oracle"]
        assert told["requests_per_repeat"] == planned and told["study"] != found["study"]
        assert run.repeats(told["study"]).picture.is_file()
        wrong = c4s("judge", "repeat", "small", "--agent", "nosuch", home=own)
        assert wrong.returncode == 2 and "unknown agent 'nosuch'" in wrong.stderr


def check(whole: Repeatability, root: Path) -> None:
    """The numbers of a study are those of its scenes, and the picture shows a mark a repeat."""
    by_name = {scene.configuration: scene for scene in whole.scenes}
    assert by_name["noop"].scores == [0.0, 0.0, 0.0] and by_name["noop"].judgements_sha256 is None
    for row in whole.configurations:
        assert row.means == by_name[row.configuration].scores
        assert row.deviations == pytest.approx([mean - row.mean for mean in row.means])
    assert any(row.sd > 0 for row in whole.configurations)
    assert [row.repeats for row in whole.agreements] == [(1, 2), (1, 3), (2, 3)]
    assert len(whole.usage) == 3 and {usage.requests for usage in whole.usage} == {whole.requests_per_repeat}
    drawn = ElementTree.parse(root / "deviations.svg").getroot()
    circles = drawn.findall("{http://www.w3.org/2000/svg}circle")
    assert len(circles) == len(whole.configurations) + 1
