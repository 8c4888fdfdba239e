"""One attempt: an engine, a gateway, an agent, and what is kept of it.

``<attempt>/`` holds ``trajectory.jsonl``, ``usage.jsonl``, ``manifest.json`` (pack digests that the engine mounted),
``submission/`` (the content that the engine saved), ``scratch/`` (engine log, job logs, screenshots), ``agent/`` (the
client's own files), and ``outcome.json``, which is written last: an attempt with it is done, one without it is repeated
and the remains are kept beside it as ``<attempt>.interrupted-<n>``.
"""

from __future__ import annotations

import json
import os
import re
import stat
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from c4s.agents.base import Agent, AgentContext, AgentReport, agent_of
from c4s.case.package import AgentCase
from c4s.engine.bridge import BridgeFault
from c4s.engine.session import EngineDied, EngineSession
from c4s.errors import AgentFault, BadInput, MachineryFault
from c4s.files import append_json_line, digest_tree, write_json
from c4s.packs.manifest import Pack
from c4s.run.records import AttemptOutcome, Configuration, EndedBy
from c4s.scene.level import Level
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import RunStopped
from c4s.toolbox.gateway import Gateway
from c4s.toolbox.run import Run
from c4s.toolbox.workbench import Workbench

GRACE_S = 30.0
"""How long an agent may take to stop after its run has ended (seconds)."""
MOST_SAVES_BYTES = 4 << 20
_PACKAGE = re.compile(r"/Game(/[A-Za-z0-9_-]+)+")


def run_attempt(case: AgentCase, agent_folder: Path, configuration: Configuration, attempt: int, folder: Path,
                packs: Sequence[Path], withheld: Path | None) -> AttemptOutcome:
    """Run one attempt and write its ``outcome.json``; an outcome that is there is returned as it is.

    Args:
        case: the agent's side of the case.
        agent_folder: the case's agent folder, with ``start.level.json``.
        configuration: which agent.
        attempt: 1 or 2.
        folder: the attempt's folder.
        packs: pack folders of the case.
        withheld: the case's withheld folder; for the client ``oracle`` alone (``BadInput`` for any other).

    What the agent does wrong is an outcome. A ``MachineryFault`` passes through and leaves no outcome: the trial stays
    pending. An engine that dies or goes silent after agent code ran in it is the agent's doing.
    """
    if (folder / "outcome.json").is_file():
        return AttemptOutcome.read(folder / "outcome.json")
    if (withheld is not None) != (configuration.client == "oracle"):
        raise BadInput("the withheld folder is for the oracle, and only for it", where=configuration.name)
    agent = agent_of(configuration)
    _set_aside(folder)
    (folder / "agent").mkdir(parents=True)
    catalog = CaseCatalog.load(case, packs)
    write_json(folder / "manifest.json", {
        "packs": {pack.name: Pack.read(pack / "pack.json").sha256() for pack in packs}, "engine": "headless"})
    (folder / "usage.jsonl").touch()
    (folder / "trajectory.jsonl").touch()
    levels, truth_package = [agent_folder / "start.level.json"], None
    if withheld is not None:
        truth_package = f"/Game/Oracle/{re.sub('[^A-Za-z0-9_-]', '_', case.case_id)}"
        levels.append(_readable_truth(withheld, folder / "oracle", truth_package))
    content, scratch = folder / "submission", folder / "scratch"
    with Gateway() as gateway, EngineSession.start(packs=packs, content=content, scratch=scratch, levels=levels,
                                                   start_map=case.start_map) as engine:
        bench = Workbench(case, agent_folder, catalog, engine, scratch)
        run = Run(f"{case.case_id}-{attempt}", bench, case.budget, folder / "trajectory.jsonl")
        context = AgentContext(case, agent_folder, gateway.open_run(run), configuration, attempt, folder / "agent",
                               truth_package)
        report, error = _work(agent, context, run)
        gateway.close_run(run)
    for record in report.usage:
        append_json_line(folder / "usage.jsonl", record)
    outcome = _outcome(run, report, error, content, attempt)
    outcome.write(folder / "outcome.json")
    return outcome


def _set_aside(folder: Path) -> None:
    """Move the remains of an attempt that was cut off out of the way, and keep them."""
    if folder.exists():
        number = 1
        while (kept := folder.with_name(f"{folder.name}.interrupted-{number}")).exists():
            number += 1
        folder.rename(kept)


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


def _outcome(run: Run, report: AgentReport, error: BaseException | None, content: Path, attempt: int
             ) -> AttemptOutcome:
    """The attempt's outcome. Raises what was the machinery's fault."""
    ended_by: EndedBy = "finished"
    message = report.message
    if run.fault is not None:
        if not (isinstance(run.fault, EngineDied | BridgeFault) and run.bench.ran_script):
            raise run.fault if isinstance(run.fault, MachineryFault) else MachineryFault(
                f"a tool failed: {type(run.fault).__name__}: {run.fault}", where=run.run_id) from run.fault
        ended_by, message = "agent_error", f"agent code ended the engine: {run.fault}"
    elif run.end_reason == "wall_budget":
        ended_by, message = "wall_budget", run.end_message
    elif run.end_reason == "killed":
        ended_by, message = "killed", run.end_message
    elif run.over_calls:
        ended_by, message = "call_budget", "the agent went on after its tool call budget was spent"
    elif isinstance(error, AgentFault) and not isinstance(error, RunStopped):
        ended_by, message = "agent_error", error.line()
    elif error is not None:
        raise error
    submission = last_saved(content)
    return AttemptOutcome(
        attempt=attempt, ended_by=ended_by, submission=submission,
        submission_sha256=digest_tree(content) if submission is not None else None, tool_calls=run.calls,
        wall_s=round(run.wall_s, 3), input_tokens=_total(report, "input_tokens"),
        output_tokens=_total(report, "output_tokens"), cost_usd=_total(report, "cost_usd"),
        client_version=report.client_version, message=" ".join(message.split())[:2000])


def _total(report: AgentReport, key: str) -> Any:
    """The sum over the usage records that have the key; None where none has it."""
    values = [record[key] for record in report.usage if record.get(key) is not None]
    return sum(values) if values else None


def last_saved(content: Path) -> str | None:
    """The last package in ``saves.jsonl`` whose level lies in ``content``.

    Agent code can write to this folder: what is no plain line with a sound package name, or leads out of the folder
    by a link, is no save.
    """
    try:
        handle = os.open(content / "saves.jsonl", os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
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
            level = content / f"{package[1:]}.level.json"
            if level.is_file() and level.resolve().is_relative_to(content.resolve()):
                return package
    return None
