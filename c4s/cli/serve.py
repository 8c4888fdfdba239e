"""``c4s serve``: the tools of one case for a client of one's own, and the score of what it saves."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.output import print_json, say
from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE, engine_kinds
from c4s.judge.names import DEFAULT_JUDGE, JUDGE_NAMES
from c4s.protocol.rules import DEFAULT_POLICY

LAST_PORT = 65_535
AFTER_SAVE_S, LONGEST_WAIT_S = 300.0, 86_400.0


def serve(
    case: Annotated[str, typer.Argument(help="case id")],
    suite: Annotated[str, typer.Option(help="id of a built suite")] = "starter",
    port: Annotated[int, typer.Option(min=0, max=LAST_PORT, help="port of the gateway (default: any)")] = 0,
    after_save: Annotated[
        float, typer.Option(min=0, max=LONGEST_WAIT_S, help="seconds without a call after a save until that is scored")
    ] = AFTER_SAVE_S,
    policy: Annotated[str, typer.Option(help="id of a score policy that ships")] = DEFAULT_POLICY,
    judge: Annotated[str, typer.Option(help=f"{', '.join(JUDGE_NAMES)}, or a judge's YAML file")] = DEFAULT_JUDGE,
    engine: Annotated[str, typer.Option(help=", ".join(engine_kinds()))] = DEFAULT_ENGINE,
    json_output: Annotated[
        bool, typer.Option("--json", help="a line of JSON once clients can connect, and one with the score")
    ] = False,
) -> None:
    """Open a case to an MCP client of your own, show its calls, and score what it saves.

    It prints how to connect. The last saved scene is scored on Ctrl-C, when the budget is spent, or when no call comes
    for a while after a save. What is served has a folder of its own under ``tries/`` and is on no leaderboard.
    """
    suite_folder = built_suite(suite)
    from c4s.cli.serving import prepare, run
    from c4s.cli.trying import print_score

    tried = prepare(suite_folder, case, port=port, after_save_s=after_save, policy=policy, judge=judge, engine=engine)
    score = run(tried, after_save_s=after_save, json_lines=json_output)
    page = tried.publish()
    if json_output:
        print_json(score.plain() | {"folder": str(tried.root), "page": page.as_uri()})
    else:
        print_score(tried.trial, score)
        say(page.as_uri())
