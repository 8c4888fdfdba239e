"""``c4s serve``: the tools of one case for a client of one's own, and the score of what it saves."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json, say
from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE, engine_kinds
from c4s.errors import BadInput
from c4s.judge.names import DEFAULT_JUDGE, JUDGE_NAMES
from c4s.names import checked_name
from c4s.protocol.rules import DEFAULT_POLICY

LAST_PORT = 65_535
AFTER_SAVE_S, LONGEST_WAIT_S = 300.0, 86_400.0


def serve(
    case: Annotated[str, typer.Argument(help="case id; with --stdio or --out also an agent's folder of a case")],
    suite: Annotated[str, typer.Option(help="id of a built suite")] = "starter",
    stdio: Annotated[
        bool, typer.Option("--stdio", help="speak MCP over standard input and output; the client ends it")
    ] = False,
    out: Annotated[
        Path | None, typer.Option(help="new folder for the attempt, which is not scored here (see `c4s grade`)")
    ] = None,
    port: Annotated[int, typer.Option(min=0, max=LAST_PORT, help="port of the gateway (default: any)")] = 0,
    after_save: Annotated[
        float, typer.Option(min=0, max=LONGEST_WAIT_S, help="seconds without a call after a save until that is scored")
    ] = AFTER_SAVE_S,
    harness: Annotated[str, typer.Option(help="program that drives the agent, for the record")] = "",
    policy: Annotated[str, typer.Option(help="id of a score policy that ships")] = DEFAULT_POLICY,
    judge: Annotated[str, typer.Option(help=f"{', '.join(JUDGE_NAMES)}, or a judge's YAML file")] = DEFAULT_JUDGE,
    engine: Annotated[str, typer.Option(help=", ".join(engine_kinds()))] = DEFAULT_ENGINE,
    json_output: Annotated[
        bool, typer.Option("--json", help="a line of JSON once clients can connect, and one with the score")
    ] = False,
) -> None:
    """Open a case to an MCP client of your own, show its calls, and score what it saves.

    It prints how to connect. The last saved scene is scored on Ctrl-C, when the budget is spent, or when no call comes
    for a while after a save. What is served has a folder of its own under ``tries/`` and is on no leaderboard. With
    ``--stdio`` or ``--out`` it only serves: that needs nothing of the withheld tree, and `c4s grade` scores the folder.
    """
    driver = checked_name(harness, "harness") if harness else None
    if stdio and (port or json_output):
        raise BadInput("a client on standard input and output needs no --port, and --json is its", where="--stdio")
    if stdio or out is not None:
        from c4s.cli.serving_apart import serve_apart, serve_stdio_client

        if stdio:
            serve_stdio_client(case, suite, out, harness=driver, engine=engine)
        else:
            assert out is not None
            serve_apart(
                case, suite, out, port=port, after_save_s=after_save, harness=driver, engine=engine, as_json=json_output
            )
        return
    suite_folder = built_suite(suite)
    from c4s.cli.serving import prepare, run
    from c4s.cli.trying import print_score

    tried = prepare(
        suite_folder,
        case,
        port=port,
        after_save_s=after_save,
        harness=driver,
        policy=policy,
        judge=judge,
        engine=engine,
    )
    score = run(tried, after_save_s=after_save, json_lines=json_output)
    page = tried.publish()
    if json_output:
        print_json(score.plain() | {"folder": str(tried.root), "page": page.as_uri()})
    else:
        print_score(tried.trial, score)
        say(page.as_uri())
