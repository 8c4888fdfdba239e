"""The whole service for real: server on PostgreSQL, work pools, workers, and what is killed among them."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import pytest

from bench.faults import MARK, contents, orphans
from bench.waiting import until
from c4s.records.lease import Lease
from c4s.records.plan import Plan
from c4s.run.lease import in_force
from c4s.run.store import FolderLeases
from tests.run.conftest import Command, apart, command_in, environment, trial_in
from tests.run.servers import answers, free_port, postgres, postgres_programs
from tests.run.test_evaluate import OFFLINE
from warehouse.database import rows

CASES = ["indoor-flat-01-mirrored-bath", "indoor-flat-02-living-room"]
AGENTS = ["noop", "random", "oracle"]


pytestmark = pytest.mark.skipif(postgres_programs() is None, reason="no PostgreSQL server is installed here")


@dataclass(frozen=True)
class Service:
    """What `c4s up` started in a home."""

    home: Path
    url: str
    settings: dict[str, str]
    c4s: Command

    def api(self, path: str, **body: Any) -> Any:
        """What the server answers."""
        answer = httpx.post(f"{self.url}/{path}", json=body, timeout=30.0)
        answer.raise_for_status()
        return answer.json()

    def start(self, deployment: str, **parameters: Any) -> str:
        """Start a deployment as an operator does; the flow run's id."""
        given = [f"--param={name}={json.dumps(value)}" for name, value in parameters.items()]
        command = [sys.executable, "-m", "prefect", "deployment", "run", deployment, *given]
        told = subprocess.run(command, env=self.settings, capture_output=True, text=True, check=True, input="")
        return next(line.split()[-1] for line in told.stdout.splitlines() if "UUID" in line)

    def ended(self, flow_run: str) -> str:
        """The state in which a flow run ends."""

        def over() -> str:
            (run,) = self.api("flow_runs/filter", flow_runs={"id": {"any_": [flow_run]}})
            ended = run["state_type"] in ("COMPLETED", "FAILED", "CRASHED", "CANCELLED")
            return f"{run['state_type']} {run['state']['message'] or ''}" if ended else ""

        return until(over)

    def holder(self, leases: Path) -> Lease:
        """Who holds a lease, as soon as somebody does."""
        found = until(lambda: in_force(FolderLeases(leases)))
        assert found
        return found


@pytest.fixture(scope="module")
def service(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Service]:
    own = apart(tmp_path_factory.mktemp("pools") / "home", home)
    mark = own.parent.name
    settings = environment(own) | OFFLINE | {MARK: mark, "PREFECT_HOME": str(own / "prefect")}
    settings.pop("PREFECT_API_URL", None)
    with postgres() as database:
        port = free_port()
        command = [
            sys.executable,
            "-m",
            "c4s.cli",
            "up",
            "--engines",
            "1",
            "--verifiers",
            "1",
            "--judges",
            "0",
            "--json",
        ]
        command += ["--port", str(port), "--database", database]
        up = subprocess.run(command, env=settings, capture_output=True, text=True, check=False)
        assert up.returncode == 0, up.stderr
        told = json.loads(up.stdout)
        worker = subprocess.Popen(
            [sys.executable, "-m", "c4s.cli", "worker", "--pool", "engines", "--url", told["url"]],
            env=settings,
            stderr=subprocess.DEVNULL,
        )
        try:
            yield Service(own, told["url"], settings | {"PREFECT_API_URL": told["url"]}, command_in(own))
        finally:
            worker.send_signal(signal.SIGINT)
            ended = worker.wait()
            down = subprocess.run(
                [sys.executable, "-m", "c4s.cli", "down"], env=settings, capture_output=True, text=True, check=False
            )
        assert (ended, down.returncode) == (0, 0), down.stderr
        assert orphans(mark) == [] and not answers(f"{told['url']}/health")


@pytest.mark.timeout(900)
def test_whoever_is_killed_the_run_ends_as_an_undisturbed_one(service: Service, c4s: Command) -> None:
    own, run = service.home, service.home / "runs/small"
    parameters = {"suite": "small", "agents": AGENTS, "cases": CASES, "workers": "pools"}
    first = service.start("evaluate/pools", **parameters)
    trial = trial_in(own, "small", "noop", CASES[0])
    engine = service.holder(trial.leases)
    os.kill(engine.owner.pid, signal.SIGKILL)
    coordinator = service.holder(run / "lease")
    scored = trial_in(own, "small", "oracle", CASES[0]).score
    until(scored.is_file)
    os.kill(coordinator.owner.pid, signal.SIGKILL)
    assert service.ended(first).startswith("CRASHED")
    second = service.start("evaluate/pools", **parameters)
    assert service.ended(second).startswith("COMPLETED")
    alone = apart(own.parent / "alone", own)
    agents = [word for name in AGENTS for word in ("-a", name)]
    cases = [word for name in CASES for word in ("-c", name)]
    assert c4s("run", "small", *agents, *cases, home=alone).returncode == 0
    assert contents(own) == contents(alone)
    assert len(list(run.glob("*/*/r1/attempt-?.interrupted-*"))) <= 2
    assert len(rows(own / "warehouse", "SELECT * FROM outcomes")) == len(AGENTS) * len(CASES)
    lost = [path.read_text() for path in run.glob("*/*/r1/faults.jsonl")]
    assert any("WorkerLost" in text for text in lost)
    table = service.api("artifacts/latest/filter", artifacts={"key": {"any_": ["run-small"]}})
    assert "oracle" in str(table), table


def test_the_server_has_pools_deployments_and_a_nightly_run(service: Service) -> None:
    pools = {pool["name"] for pool in service.api("work_pools/filter")}
    assert pools == {"coordinators", "engines", "verifiers", "judges"}
    flows = {flow["id"]: flow["name"] for flow in service.api("flows/filter")}
    found = {f"{flows[one['flow_id']]}/{one['name']}": one for one in service.api("deployments/filter")}
    assert found.keys() == {
        *("evaluate/pools", "evaluate/here", "trial/engines", "trial/verifiers", "trial/judges"),
        *("leaderboard/nightly", "reverify/default", "rejudge/default", "curate/default", "repeatability/default"),
    }
    for name, one in found.items():
        for parameter, schema in one["parameter_openapi_schema"]["properties"].items():
            assert schema.get("description"), f"{name}: {parameter} says nothing of itself"
        assert one["tags"] and one["description"] and not one["pull_steps"], name
    shown = found["evaluate/pools"]["parameter_openapi_schema"]["properties"]
    assert shown["workers"]["enum"] == ["here", "pools"] and "headless" in str(shown["engine"])
    nightly = found["leaderboard/nightly"]["id"]
    until(lambda: service.api("flow_runs/filter", deployments={"id": {"any_": [nightly]}}))


def test_stored_evidence_is_verified_and_judged_anew(service: Service) -> None:
    before = rows(service.home / "warehouse", "SELECT configuration, case_id, score FROM outcomes ORDER BY ALL")
    assert service.ended(service.start("reverify/default", run_id="small", agents=["oracle"])).startswith("COMPLETED")
    after = rows(service.home / "warehouse", "SELECT configuration, case_id, score FROM outcomes ORDER BY ALL")
    trial = trial_in(service.home, "small", "oracle", CASES[0])
    assert before == after and list(trial.verdict("repair").parent.glob("repair.json.outdated-*"))
    assert Plan.read(service.home / "runs/small/plan.json").run_id == "small"


def test_up_again_starts_nothing_and_doctor_sees_all_of_it(service: Service) -> None:
    again = service.c4s("up", "--engines", "1", "--verifiers", "1", "--judges", "0")
    assert again.returncode == 0 and "started" not in again.stderr and "starting" not in again.stderr
    told = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "doctor", "--json"],
        env=service.settings,
        capture_output=True,
        text=True,
        check=False,
    )
    found = {row["what"]: row for row in json.loads(told.stdout)}
    assert found["Prefect server"]["found"] and found["Prefect deployments"]["found"]
    assert "2 workers" in found["pool engines"]["text"] and found["pool judges"]["found"] is False
