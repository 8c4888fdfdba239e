"""One attempt: an engine, a gateway, an agent, and what is kept of it.

``c4s.records.folder`` tells what lies in an attempt's folder. The outcome is written last: an attempt with it is done,
one without it is repeated and the remains are kept beside it as ``<attempt>.interrupted-<n>``.
"""

from __future__ import annotations

import json
import os
import re
import stat
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from c4s.agents.base import Agent, AgentContext, AgentReport, ModelClient, Reached, agent_of
from c4s.agents.model import ModelAccess, open_model
from c4s.engine import DEFAULT_ENGINE, Engine, backend, open_engine
from c4s.engine.content import content_fault
from c4s.errors import BadInput, C4SError, Place, shortage
from c4s.files import append_json_line, json_lines, opened_folder, write_json
from c4s.meter.record import sums
from c4s.meter.spending import SpendingLimitReached
from c4s.protocol.baselines import ORACLE
from c4s.records.attempt import AttemptOutcome, EndedBy
from c4s.records.folder import SAVES, AttemptFolder
from c4s.records.level import Level
from c4s.records.pack import Pack
from c4s.records.plan import Configuration
from c4s.records.suite import AgentCase
from c4s.run.aside import set_aside
from c4s.run.check import freeze_submission
from c4s.run.faults import of_machinery, whose
from c4s.run.headroom import check_room
from c4s.run.inputs import offered
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.gateway import Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.workbench import Workbench

GRACE_S = 30.0
"""How long an agent may take to stop after its run has ended (seconds)."""
MOST_SAVES_BYTES = 4 << 20
_PACKAGE = re.compile(r"/Game(/[A-Za-z0-9_-]+)+")


def run_attempt(
    case: AgentCase,
    agent_folder: Path,
    configuration: Configuration,
    attempt: int,
    folder: Path,
    packs: Sequence[Path],
    withheld: Path | None,
    ledger: Path | None = None,
    engine: str = DEFAULT_ENGINE,
    agent: Agent | None = None,
) -> AttemptOutcome:
    """Run one attempt and write its outcome; an outcome that is there is returned as it is.

    Args:
        case: the agent's side of the case.
        agent_folder: the case's agent folder, with ``start.level.json``.
        configuration: which agent.
        attempt: 1 or 2.
        folder: the attempt's folder.
        packs: pack folders of the case.
        withheld: the case's withheld folder; for the client ``oracle`` alone (``BadInput`` for any other).
        ledger: spending file of the whole run, which holds its limit; no limit is kept without it.
        engine: kind of the engine.
        agent: who works, where that is no client that the configuration's name starts.

    What the agent does wrong is an outcome (``c4s.run.faults`` tells what that is). All else passes through and leaves
    no outcome: the trial stays pending. Records go into the folder that was made here: where another holder of the
    trial has moved it away and works anew, what that one records is not touched.
    """
    paths = AttemptFolder(folder)
    if paths.done:
        return AttemptOutcome.read(paths.outcome)
    if (withheld is not None) != (configuration.client == ORACLE):
        raise BadInput("the withheld folder is for the oracle, and only for it", where=configuration.name)
    agent = agent or agent_of(configuration)
    if isinstance(agent, ModelClient):
        agent.ready(configuration)
    set_aside(folder)
    paths.agent.mkdir(parents=True)
    with opened_folder(folder) as opened:
        own = AttemptFolder(opened)
        catalog = CaseCatalog.load(case, packs)
        own.usage.touch()
        own.trajectory.touch()
        levels, truth_package = [agent_folder / "start.level.json"], None
        if withheld is not None:
            truth_package = f"/Game/Oracle/{re.sub('[^A-Za-z0-9_-]', '_', case.alias)}"
            levels.append(_readable_truth(withheld, folder / "oracle", truth_package))
        content, scratch = paths.submission, paths.scratch
        stopping = _Stopping()
        with (
            _model(agent, configuration, own.usage, ledger, stopping) as model,
            Gateway(port=agent.port_of(configuration) if isinstance(agent, Reached) else 0) as gateway,
            open_engine(
                engine,
                packs=packs,
                content=content,
                scratch=scratch,
                levels=levels,
                start_map=case.start_map,
                offered=offered(case, agent_folder),
            ) as session,
        ):
            write_json(own.manifest, _manifest(session, packs, agent))
            bench = Workbench(case, agent_folder, catalog, session, scratch)
            run = Run(f"{case.alias}-{attempt}", bench, case.budget, own.trajectory)
            context = AgentContext(
                case,
                agent_folder,
                gateway.open_run(run),
                configuration,
                attempt,
                paths.agent,
                truth_package,
                model,
                lambda seconds: run.ended.wait(seconds) or run.over_calls,
            )
            stopping.run = run
            report, error = _work(agent, context, run)
            check_room()
            engine_version, sandbox = session.version, session.sandbox
            gateway.close_run(run)
        if model is not None and model.run.limit_message:
            raise SpendingLimitReached(
                model.run.limit_message,
                where=f"{configuration.name}/{case.alias}",
                todo="raise the limit and run the same command again",
            )
        for record in report.usage:
            append_json_line(own.usage, record)
        outcome = _outcome(
            run, report, error, own.submission, context, engine_version, sandbox, backend(engine).level_suffix
        )
        outcome.write(own.outcome)
        return outcome


def _manifest(engine: Engine, packs: Sequence[Path], agent: Agent) -> dict[str, Any]:
    """Which engine serves the attempt, what confines it and the agent, and the digests of the packs that it mounted."""
    return {
        "packs": {pack.name: Pack.read(pack / "pack.json").sha256() for pack in packs},
        "engine": engine.kind,
        "engine_version": engine.version,
        "sandbox": engine.sandbox,
        "client_sandbox": getattr(agent, "sandbox", ""),
    }


class _Stopping:
    """Ends the run from the server's side; the meter calls it when the spending limit is reached."""

    run: Run | None = None

    def __call__(self) -> None:
        if self.run is not None:
            self.run.end("killed", "the spending limit is reached")


@contextmanager
def _model(
    agent: Agent, configuration: Configuration, usage: Path, ledger: Path | None, stopping: _Stopping
) -> Iterator[ModelAccess | None]:
    """A meter for an agent that uses a model; None for one that does not."""
    if not isinstance(agent, ModelClient):
        yield None
        return
    with open_model(
        configuration, agent.endpoint, agent.wire_of(configuration), usage=usage, ledger=ledger, at_limit=stopping
    ) as access:
        yield access


def _readable_truth(withheld: Path, folder: Path, package: str) -> Path:
    """A copy of the truth under a package name of its own: engines refuse files of a withheld tree."""
    truth = Level.read(withheld / "truth.level.json").model_copy(update={"package": package})
    truth.write(folder / "truth.level.json")
    return folder / "truth.level.json"


def _work(agent: Agent, context: AgentContext, run: Run) -> tuple[AgentReport, BaseException | None]:
    """Let the agent work in a thread until it is done or its run ends: its report, and what it raised."""
    reports: list[AgentReport] = []
    errors: list[BaseException] = []

    def work() -> None:
        try:
            reports.append(agent.run(context))
        except BaseException as error:
            errors.append(error)
        finally:
            done.set()

    done = threading.Event()
    thread = threading.Thread(target=work, name=f"agent-{run.run_id}", daemon=True)
    thread.start()
    run.ended_or(done)
    if run.end_reason is not None:
        done.wait(GRACE_S)
    return (reports[0] if reports else AgentReport()), (errors[0] if errors else None)


def _outcome(
    run: Run,
    report: AgentReport,
    error: BaseException | None,
    content: Path,
    context: AgentContext,
    engine_version: str,
    sandbox: str,
    level_suffix: str,
) -> AttemptOutcome:
    """The attempt's outcome. Raises what was the machinery's fault."""
    ended_by: EndedBy = "finished"
    message = report.message
    place: Place = "attempt_with_code" if run.bench.ran_script else "attempt"
    if run.fault is not None:
        if whose(run.fault, place) != "agent":
            raise of_machinery(run.fault, where=run.run_id) from run.fault
        ended_by, message = "agent_error", f"agent code broke the engine: {run.fault}"
    elif run.end_reason == "wall_budget":
        ended_by, message = "wall_budget", run.end_message
    elif run.end_reason == "killed":
        ended_by, message = "killed", run.end_message
    elif run.over_calls:
        ended_by, message = "call_budget", "the agent went on after its tool call budget was spent"
    elif error is not None:
        if whose(error, place) != "agent":
            raise of_machinery(error, where=run.run_id) from error
        ended_by, message = "agent_error", error.line() if isinstance(error, C4SError) else str(error)
    unsound = content_fault(content)
    if unsound is not None:
        ended_by, message = "agent_error", f"agent code left what cannot be submitted: {unsound}"
    submission = last_saved(content, level_suffix) if unsound is None else None
    with AttemptFolder(content.parent).usage.open(encoding="utf-8") as lines:
        used = sums(list(json_lines(lines)))
    return AttemptOutcome(
        attempt=context.attempt,
        ended_by=ended_by,
        submission=submission,
        submission_sha256=freeze_submission(AttemptFolder(content.parent)) if submission is not None else None,
        tool_calls=run.calls,
        wall_s=round(run.wall_s, 3),
        input_tokens=used["input_tokens"],
        output_tokens=used["output_tokens"],
        cost_usd=used["cost_usd"],
        client=context.configuration.client,
        model=context.configuration.model,
        client_version=report.client_version,
        engine_version=engine_version,
        sandbox=sandbox,
        message=" ".join(message.split())[:2000],
    )


def last_saved(content: Path, level_suffix: str) -> str | None:
    """The last package in the list of saves whose level lies in ``content``, in a file with the engine's suffix.

    Agent code can write to this folder: what is no plain line with a sound package name, or leads out of the folder
    by a link, is no save.
    """
    try:
        handle = os.open(content / SAVES, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError as error:
        if shortage(error) is not None:
            raise
        return None
    with os.fdopen(handle, "rb") as source:
        if not stat.S_ISREG(os.fstat(handle).st_mode):
            return None
        lines = source.read(MOST_SAVES_BYTES).decode("utf-8", "replace").splitlines()
    for line in reversed(lines):
        try:
            saved = json.loads(line)
        except (ValueError, RecursionError):
            continue
        package = saved.get("package") if isinstance(saved, dict) else None
        if isinstance(package, str) and _PACKAGE.fullmatch(package):
            level = content / f"{package[1:]}{level_suffix}"
            if level.is_file() and level.resolve().is_relative_to(content.resolve()):
                return package
    return None
