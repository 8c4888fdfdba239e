"""The agent's side of ``c4s serve`` alone: an attempt is made and kept; its score is for ``c4s grade``."""

from __future__ import annotations

from pathlib import Path

from c4s.agents.by_stdio import StdioAgent
from c4s.agents.outside import OUTSIDE
from c4s.cli.output import print_json, say, say_beside
from c4s.cli.serving import attended, outside
from c4s.cli.suites import built_suite
from c4s.cli.trying import say_ending
from c4s.folders import numbered_folder
from c4s.home import home
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.plan import Configuration
from c4s.records.suite import SuiteFolder
from c4s.run.agent_side import CASE, AgentSide
from c4s.run.choices import check_labels


def serve_stdio_client(case: str, suite: str, out: Path | None, *, harness: str | None, engine: str) -> None:
    """An attempt by whoever started this process; nothing but the protocol goes to standard output."""
    check_labels(engine, DEFAULT_POLICY)
    side = agent_side(case, suite)
    kept = out if out is not None else numbered_folder(home() / "tries", f"{OUTSIDE}-{side.case.alias}") / "attempt-1"
    chosen = Configuration(name=OUTSIDE, client=OUTSIDE, harness=harness)
    say_beside(f"{side.case.alias}: the tools are open; the attempt is kept in {kept}")
    outcome = side.attempt(chosen, kept, engine=engine, agent=StdioAgent())
    saved = f"saved {outcome.submission}" if outcome.submission else "nothing was saved"
    say_beside(f"{outcome.ended_by}: {outcome.tool_calls} calls in {outcome.wall_s:.1f} s; {saved}")


def serve_apart(
    case: str, suite: str, out: Path, *, port: int, after_save_s: float, harness: str | None, engine: str, as_json: bool
) -> None:
    """An attempt by a client that connects over HTTP, as it is told."""
    check_labels(engine, DEFAULT_POLICY)
    side = agent_side(case, suite)
    chosen = outside(port=port, after_save_s=after_save_s, harness=harness)
    with attended(out, side.case.budget, after_save_s=after_save_s, json_lines=as_json):
        outcome = side.attempt(chosen, out, engine=engine)
    if as_json:
        print_json(outcome.plain() | {"folder": str(out)})
    else:
        say_ending(out)
        say(f"c4s grade {out} --case {case} --suite {suite}")


def agent_side(case: str, suite: str) -> AgentSide:
    """A case by its id in a built suite, or by the agent's folder of it."""
    if (Path(case) / CASE).is_file():
        return AgentSide.of_folder(Path(case))
    return AgentSide.of_suite(SuiteFolder(built_suite(suite)), case)
