"""``c4s score``: scores of a batch of rows, or a run's stored verdicts under another policy."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.batches import write_rows
from c4s.cli.output import print_json, print_table, say
from c4s.cli.runs import run_folder
from c4s.errors import BadInput
from c4s.protocol.rules import DEFAULT_POLICY

SHOWN = 40


def score(
    run: Annotated[str | None, typer.Argument(help="run id or run folder to score again")] = None,
    batch: Annotated[Path | None, typer.Option("--batch", help="JSON lines (optionally gzip), one row each")] = None,
    policy: Annotated[str, typer.Option(help="policy id or policy file")] = DEFAULT_POLICY,
    json_output: Annotated[bool, typer.Option("--json", help="the whole delta report as JSON")] = False,
) -> None:
    """What another policy would change in a run (stored files stay as they are), or scores of a batch of rows."""
    if (run is None) == (batch is None):
        raise BadInput("give either a run or --batch FILE")
    if batch is not None:
        if policy != DEFAULT_POLICY:
            raise BadInput("--policy is for a run, not for --batch FILE")
        from c4s.score.batch import score_batch

        write_rows(batch, score_batch)
    elif run is not None:
        _rescore(run, policy, json_output)


def _exact(value: float | None) -> str:
    """Six decimals, so that a change in the last published digit is seen."""
    return "–" if value is None else f"{value:.6f}"


def _rescore(run: str, policy: str, json_output: bool) -> None:
    from c4s.score.policies import policy_named
    from c4s.score.rescore import rescore

    found = rescore(run_folder(run), policy_named(policy))
    report = found.report()
    if json_output:
        print_json(report)
        return
    say(
        f"{found.run_id} under {found.policy.policy_id}: {report['changed_trials']} of {report['trials']} trials "
        f"change"
        + (f", {len(found.pending)} have no score here (pending, or reused from another run)" if found.pending else "")
    )
    if report["means"]:
        print_table(
            ["configuration", "setting", "trials", "stored mean", "new mean"],
            [[row["configuration"], row["setting"], row["trials"], row["from"], row["to"]] for row in report["means"]],
        )
    deltas = report["deltas"]
    if deltas:
        print_table(
            ["trial", "component", "stored", "new"],
            [[row["trial"], row["component"], _exact(row["from"]), _exact(row["to"])] for row in deltas[:SHOWN]],
        )
    if len(deltas) > SHOWN:
        say(f"and {len(deltas) - SHOWN} more; --json lists all")
