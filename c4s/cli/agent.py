"""``c4s agent``: the clients, one trial to look at, and a recorded attempt played again."""

from __future__ import annotations

import os
import tempfile
import webbrowser
from pathlib import Path
from typing import Annotated, Any

import typer

from c4s.agents.base import CLIENTS, MODEL_CLIENTS, Agent, ModelClient, agent_of
from c4s.agents.joining import joined
from c4s.cli.output import print_json, print_table, say
from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE, backend, engine_kinds
from c4s.errors import BadInput, C4SError
from c4s.files import read_json
from c4s.judge.names import DEFAULT_JUDGE, JUDGE_NAMES
from c4s.protocol.baselines import ORACLE
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder
from c4s.records.plan import Configuration
from c4s.run.configurations import configuration

app = typer.Typer(
    help="Agent clients: which there are, one trial with live output, a recorded attempt again.", no_args_is_help=True
)


@app.command("list")
def list_clients(json_output: Annotated[bool, typer.Option("--json")] = False) -> None:
    """The agent clients, and whether each can be started here: installed, with the key of its usual endpoint."""
    from c4s.meter.endpoints import key_of, model_endpoint

    own = [{"client": name, "from": "c4s"} for name in CLIENTS]
    others = [{"client": name, "from": client.distribution} for name, client in joined(CLIENTS).items()]
    rows: list[dict[str, Any]] = []
    for row in [*own, *others]:
        uses_model, problem = False, ""
        try:
            plain = row["from"] == "c4s" and row["client"] not in MODEL_CLIENTS
            agent = None if plain else _agent_of(row["client"], row["from"])
            if isinstance(agent, ModelClient):
                uses_model = True
                agent.ready(Configuration(name=row["client"], client=row["client"]))
                key_of(agent.endpoint, model_endpoint(agent.endpoint))
        except C4SError as error:
            problem = error.line()
        rows.append({**row, "model": uses_model, "ready": not problem, "problem": problem})
    if json_output:
        print_json(rows)
        return
    print_table(
        ("client", "from", "uses a model", "ready", ""),
        [(row["client"], row["from"], row["model"], row["ready"], row["problem"]) for row in rows],
    )


def _agent_of(name: str, source: str) -> Agent:
    """An agent by the name of its client; a name that c4s has too is taken of the other distribution."""
    if source == "c4s":
        return agent_of(Configuration(name=name, client=name))
    made: Agent = joined(CLIENTS)[name].make()
    return made


@app.command("try")
def try_agent(
    name: Annotated[str, typer.Argument(help="configuration: a baseline, or a YAML file")],
    case: Annotated[str, typer.Option("--case", "-c", help="case id")],
    suite: Annotated[str, typer.Option(help="id of a built suite")] = "starter",
    policy: Annotated[str, typer.Option(help="id of a score policy that ships")] = DEFAULT_POLICY,
    judge: Annotated[str, typer.Option(help=f"{', '.join(JUDGE_NAMES)}, or a judge's YAML file")] = DEFAULT_JUDGE,
    engine: Annotated[str, typer.Option(help=", ".join(engine_kinds()))] = DEFAULT_ENGINE,
    open_page: Annotated[
        bool, typer.Option("--open/--no-open", help="open the case page at the end, where there is a desktop")
    ] = True,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Run one trial and watch it: every call, the budget left, the cost, the pictures; then its case page.

    A try has a folder of its own under ``tries/`` and is on no leaderboard.
    """
    suite_folder = built_suite(suite)
    from c4s.cli.trying import Try, print_score, watch

    tried = Try.prepare(configuration(name), suite_folder, case, policy=policy, judge=judge, engine=engine)
    if not json_output:
        say(f"{tried.trial.name}, in {tried.root}", style="dim")
    score = tried.run(None if json_output else watch)
    page = tried.publish()
    if json_output:
        print_json(score.plain() | {"folder": str(tried.root), "page": page.as_uri()})
    else:
        print_score(tried.trial, score)
        say(f"c4s agent replay {tried.trial.folder.attempts()[-1].root}")
        say(page.as_uri())
    if open_page and not json_output and (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        webbrowser.open(page.as_uri())


def _engine_of(attempt: AttemptFolder) -> str:
    """The kind of engine that an attempt ran on; ``BadInput`` where its manifest names none that is here."""
    manifest = read_json(attempt.manifest, what="attempt manifest")
    if not isinstance(manifest, dict) or not isinstance(manifest.get("engine"), str):
        raise BadInput("this attempt manifest names no engine", where=str(attempt.manifest))
    backend(manifest["engine"])
    return str(manifest["engine"])


@app.command("replay")
def replay(
    attempt: Annotated[Path, typer.Argument(help="folder of a finished attempt in a run")],
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Send the calls of a recorded attempt again and compare what is saved, byte by byte. Exit 1 when it differs."""
    from c4s.cli.trying import trial_of
    from c4s.run.attempt import run_attempt
    from c4s.run.inputs import inputs
    from c4s.trajectory.lines import read_lines

    trial = trial_of(attempt)
    recorded = AttemptOutcome.read(AttemptFolder(attempt).outcome)
    read_lines(AttemptFolder(attempt).trajectory)
    engine = _engine_of(AttemptFolder(attempt))
    if trial.working.client == ORACLE:
        raise BadInput("the oracle reads the truth, which a replay is not given", where=str(attempt))
    given = inputs(trial)
    with tempfile.TemporaryDirectory(prefix="c4s-replay-") as folder:
        again = run_attempt(
            given.case,
            given.agent_folder,
            Configuration(
                name="replay",
                client="replay",
                options={"trajectory": str(AttemptFolder(attempt.absolute()).trajectory)},
            ),
            recorded.attempt,
            Path(folder) / "attempt",
            given.packs,
            None,
            engine=engine,
        )
    equal = (again.submission, again.submission_sha256) == (recorded.submission, recorded.submission_sha256)
    if json_output:
        print_json(
            {
                "equal": equal,
                "recorded_sha256": recorded.submission_sha256,
                "replayed_sha256": again.submission_sha256,
                "tool_calls": again.tool_calls,
                "message": again.message,
            }
        )
    else:
        say(f"{again.message}; the submission is {'equal, byte by byte' if equal else 'another one'}")
    if not equal:
        raise typer.Exit(1)
