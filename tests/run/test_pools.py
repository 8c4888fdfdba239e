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
from c4s.records.lease import Lease, Owner
from c4s.records.plan import Plan
from c4s.run.lease import in_force
from c4s.run.owner import is_gone
from c4s.run.store import FolderLeases
from tests.run.conftest import Command, apart, command_in, environment, trial_in
from tests.run.handed_on import baselines_home, hand_on
from tests.run.servers import answers, free_port, postgres, postgres_programs
from tests.run.test_evaluate import OFFLINE
from warehouse.database import rows

CASES = ["indoor-flat-01-mirrored-bath", "indoor-flat-02-living-room"]
AGENTS = ["noop", "oracle"]
ASKED_S = 0.5
"""Between two questions to the server, which shares the processors with the work that it is asked for."""
SILENT = """
import asyncio, json
from prefect.client.orchestration import get_client
from prefect.client.schemas.filters import FlowRunFilter, FlowRunFilterTags
from prefect.states import Running
from c4s.home import runs_root
from c4s.records.handover import Handover
from c4s.records.suite import SuiteFolder
from c4s.run.configurations import configuration
from c4s.run.lease import holding
from c4s.run.overseer import Overseer
from c4s.run.plan import make_plan, open_run, trials
from c4s.run.store import share_suite
from flows import coordinate

coordinate.SILENT_S, coordinate.LOOK_S = 0.5, 0.05
suite, run, told = share_suite("small"), runs_root() / "silent", []

async def begun(count):
    \"""A worker that takes flow runs and is never heard of again: the pool has no other.\"""
    asked = FlowRunFilter(tags=FlowRunFilterTags(all_=["run:silent"]))
    async with get_client() as client:
        while True:
            for found in await client.read_flow_runs(flow_run_filter=asked):
                if found.state_name in ("Scheduled", "Late"):
                    await client.set_flow_run_state(found.id, Running(), force=True)
            await asyncio.sleep(0.05)

async def work():
    plan = make_plan(
        SuiteFolder(suite),
        [configuration("noop")],
        run_id="silent",
        policy="code4scene-published",
        judge="rule",
        engine="headless",
        cases=["text-flat-family"],
    )
    with holding(run) as held:
        open_run(run, plan)
        (trial,) = trials(run, suite, plan)
        trial.folder.root.mkdir(parents=True)
        Handover(part="earlier", ended="handed_over", pool="judges").write(trial.folder.handover)
        worker = asyncio.create_task(begun(4))
        pending = await coordinate.Coordinator(plan, held, Overseer(run), told.append).run([trial])
        worker.cancel()
    faults = [json.loads(line)["error"] for line in trial.folder.faults.read_text().splitlines()]
    print(json.dumps([[one.error.line() for one in pending], told, faults]))

asyncio.run(work())
"""

pytestmark = pytest.mark.skipif(postgres_programs() is None, reason="no PostgreSQL server is installed here")


@dataclass(frozen=True)
class Service:
    """What `c4s up` started in a home."""

    home: Path
    url: str
    database: str
    settings: dict[str, str]
    c4s: Command
    client: httpx.Client

    def api(self, path: str, **body: Any) -> Any:
        """What the server answers."""
        answer = self.client.post(f"{self.url}/{path}", json=body)
        answer.raise_for_status()
        return answer.json()

    def start(self, deployment: str, **parameters: Any) -> str:
        """Start a deployment over the server's interface; the flow run's id."""
        found = self.client.get(f"{self.url}/deployments/name/{deployment}").raise_for_status().json()
        return str(self.api(f"deployments/{found['id']}/create_flow_run", parameters=parameters)["id"])

    def start_by_hand(self, deployment: str, **parameters: Any) -> str:
        """Start a deployment as an operator does; the flow run's id."""
        given = [f"--param={name}={json.dumps(value)}" for name, value in parameters.items()]
        command = [sys.executable, "-m", "prefect", "deployment", "run", deployment, *given]
        told = subprocess.run(command, env=self.settings, capture_output=True, text=True, check=True, input="")
        return next(line.split()[-1] for line in told.stdout.splitlines() if "UUID" in line)

    def ended(self, flow_run: str) -> str:
        """The state in which a flow run ends."""

        def over() -> str | None:
            (run,) = self.api("flow_runs/filter", flow_runs={"id": {"any_": [flow_run]}})
            ended = run["state_type"] in ("COMPLETED", "FAILED", "CRASHED", "CANCELLED")
            return f"{run['state_type']} {run['state']['message'] or ''}" if ended else None

        return until(over, pause_s=ASKED_S)

    def holder(self, leases: Path) -> Lease:
        """Who holds a lease, as soon as somebody does."""
        return until(lambda: in_force(FolderLeases(leases)))


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
            reached = settings | {"PREFECT_API_URL": told["url"]}
            with httpx.Client(timeout=30.0) as client:
                yield Service(own, told["url"], database, reached, command_in(own), client)
        finally:
            worker.send_signal(signal.SIGINT)
            ended = worker.wait()
            down = subprocess.run(
                [sys.executable, "-m", "c4s.cli", "down"], env=settings, capture_output=True, text=True, check=False
            )
        assert (ended, down.returncode) == (0, 0), down.stderr
        assert orphans(mark) == [] and not answers(f"{told['url']}/health")


@pytest.mark.timeout(900)
def test_whoever_is_killed_the_run_ends_as_an_undisturbed_one(
    service: Service, tmp_path_factory: pytest.TempPathFactory
) -> None:
    own, run = service.home, service.home / "runs/small"
    parameters = {"suite": "small", "agents": AGENTS, "cases": CASES, "workers": "pools"}
    first = service.start_by_hand("evaluate/pools", **parameters)
    trial = trial_in(own, "small", "noop", CASES[0])
    engine = service.holder(trial.leases)
    os.kill(engine.owner.pid, signal.SIGKILL)
    coordinator = service.holder(run / "lease")
    scored = trial_in(own, "small", "oracle", CASES[0]).score
    until(scored.is_file)
    os.kill(coordinator.owner.pid, signal.SIGKILL)
    assert service.ended(first).startswith("CRASHED")
    listed = json.loads(service.c4s("runs", "list", "--json").stdout)
    assert {row["state"] for row in listed if row["run"] == "small"} <= {"running", "idle"}
    second = service.start("evaluate/pools", **parameters)
    assert service.ended(second).startswith("COMPLETED")
    alone = apart(own.parent / "alone", own)
    hand_on(baselines_home(tmp_path_factory), alone, AGENTS, CASES)
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
        *(
            "leaderboard/nightly",
            "reverify/stored-evidence",
            "rejudge/stored-evidence-judged-anew",
            "curate/suite",
            "repeatability/judgements-repeated",
        ),
    }
    for name, one in found.items():
        for parameter, schema in one["parameter_openapi_schema"]["properties"].items():
            assert schema.get("description"), f"{name}: {parameter} says nothing of itself"
        assert one["tags"] and one["description"] and not one["pull_steps"], name
    shown = found["evaluate/pools"]["parameter_openapi_schema"]["properties"]
    assert shown["workers"]["enum"] == ["here", "pools"] and "headless" in str(shown["engine"])
    assert (shown["repeats"]["minimum"], shown["repeats"]["maximum"], shown["most_faults"]["minimum"]) == (1, 1000, 1)
    nightly = found["leaderboard/nightly"]["id"]
    until(lambda: service.api("flow_runs/filter", deployments={"id": {"any_": [nightly]}}) or None)


def test_stored_evidence_is_verified_and_judged_anew(service: Service) -> None:
    before = rows(service.home / "warehouse", "SELECT configuration, case_id, score FROM outcomes ORDER BY ALL")
    assert service.ended(service.start("reverify/stored-evidence", run_id="small", agents=["oracle"])).startswith(
        "COMPLETED"
    )
    after = rows(service.home / "warehouse", "SELECT configuration, case_id, score FROM outcomes ORDER BY ALL")
    trial = trial_in(service.home, "small", "oracle", CASES[0])
    assert before == after and list(trial.verdict("repair").parent.glob("repair.json.outdated-*"))
    assert Plan.read(service.home / "runs/small/plan.json").run_id == "small"


def test_one_home_has_one_service_however_it_is_asked_for(service: Service) -> None:
    slots = ["--engines", "1", "--verifiers", "1", "--judges", "0"]
    both = [
        subprocess.Popen(
            [sys.executable, "-m", "c4s.cli", "up", *slots], env=service.settings, stderr=subprocess.PIPE, text=True
        )
        for _ in range(2)
    ]
    told = [process.communicate()[1] for process in both]
    assert [process.returncode for process in both] == [0, 0] and all("nothing was missing" in text for text in told)
    other = service.c4s("up", *slots, "--port", str(free_port()))
    assert other.returncode == 2 and f"the server of {service.url} is used here" in other.stderr
    record = json.loads((service.home / "service.json").read_text())
    os.kill(record["server"]["pid"], signal.SIGKILL)
    until(lambda: is_gone(Owner.parse(record["server"], where="server")))
    unsaid = service.c4s("up", *slots)
    assert unsaid.returncode == 2 and "give --database again" in unsaid.stderr, unsaid.stderr
    back = service.c4s("up", *slots, "--database", service.database)
    assert back.returncode == 0 and f"starting the server at {service.url.removesuffix('/api')}" in back.stderr
    now = json.loads((service.home / "service.json").read_text())
    assert now["workers"] == record["workers"] and now["url"] == service.url


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


def test_work_that_gives_no_sign_of_life_is_asked_for_again_and_at_last_left_pending(service: Service) -> None:
    command = [sys.executable, "-c", SILENT]
    ended = subprocess.run(command, env=service.settings | OFFLINE, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr[-3000:]
    (pending,), told, faults = json.loads(ended.stdout.splitlines()[-1])
    lost = "a worker of the pool 'judges' was lost at work (no sign of life)"
    assert lost in pending and len(told) == 3 and all(lost in line and "asked for again" in line for line in told)
    assert faults == ["WorkerLost"] * 4
    runs = service.api("flow_runs/filter", flow_runs={"tags": {"all_": ["run:silent"]}})
    assert [run["state_type"] for run in runs] == ["CRASHED"] * 4


def test_a_run_on_pools_pauses_drains_and_goes_on(service: Service) -> None:
    given = {"suite": "small", "run_id": "drained", "agents": AGENTS, "cases": CASES, "repeats": 2, "workers": "pools"}
    question = "SELECT * FROM outcomes WHERE run_id = 'drained'"
    first = service.start("evaluate/pools", **given)
    until((service.home / "runs/drained/guards.json").is_file)
    assert service.c4s("runs", "pause", "drained").returncode == 0
    until(lambda: '"paused"' in service.c4s("runs", "list", "--json").stdout)
    assert service.c4s("runs", "go-on", "drained").returncode == 0
    assert service.c4s("runs", "drain", "drained").returncode == 0
    ended = service.ended(first)
    assert ended.startswith("FAILED") and "asked it to drain" in ended and "trials left" in ended, ended
    assert len(rows(service.home / "warehouse", question)) < len(AGENTS) * len(CASES)
    faults = [path.read_text() for path in (service.home / "runs/drained").glob("*/*/r?/faults.jsonl")]
    assert not any("WorkerLost" in text for text in faults), "what a guard left undone was lost by nobody"
    for attempt in (service.home / "runs/drained").glob("*/*/r?/attempt-1/outcome.json"):
        assert (attempt.parents[1] / "score.json").is_file(), "what was in work was verified and scored"
    assert service.ended(service.start("evaluate/pools", **given)).startswith("COMPLETED")
    assert len(rows(service.home / "warehouse", question)) == len(AGENTS) * len(CASES)
