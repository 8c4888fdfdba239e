"""``c4s verify``: one verifier on files, or on a batch of rows."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.batches import write_rows
from c4s.cli.output import check_new_file, print_json, print_table, say
from c4s.errors import BadInput, MachineryFault, unknown
from c4s.files import read_json, write_json
from c4s.folders import check_out
from c4s.numbers import half_up
from c4s.protocol.settings import SETTINGS, TEXT_TO_SCENE
from c4s.records.navigation import NavigationEvidence
from c4s.records.snapshot import read_snapshot
from c4s.records.verdict import Verdict

app = typer.Typer(help="Verify saved scenes: repair, physics, support, navigation.", no_args_is_help=True)
Batch = Annotated[Path | None, typer.Option("--batch", help="JSON lines (optionally gzip), one row each")]
Json = Annotated[bool, typer.Option("--json", help="the whole verdict as JSON")]


def _print(verdict: Verdict, json_output: bool) -> None:
    """The verdict; one that could not be made (status ``error``) ends the command with a machinery fault's status."""
    if json_output:
        print_json(verdict.plain())
    else:
        _print_text(verdict)
    if verdict.status == "error":
        raise typer.Exit(MachineryFault.exit_code)


def _print_text(verdict: Verdict) -> None:
    score = "–" if verdict.score is None else half_up(verdict.score, 3)
    say(f"{verdict.verifier}: {verdict.status}, score {score}{'. ' + verdict.reason if verdict.reason else ''}")
    if verdict.population:
        print_table(["population", "count"], [[name, count] for name, count in verdict.population.items()])
    for advisory in verdict.advisories:
        say(f"advisory {advisory['code']}: {advisory['text']}")


def _given(path: Path | None, option: str) -> Path:
    if path is None:
        raise BadInput(f"option {option} is missing", todo="give the scene files, or --batch FILE")
    return path


@app.command()
def repair(
    start: Annotated[Path | None, typer.Option("--input", help="snapshot of the start scene")] = None,
    truth: Annotated[Path | None, typer.Option(help="snapshot of the original scene")] = None,
    candidate: Annotated[Path | None, typer.Option(help="snapshot of the saved scene")] = None,
    batch: Batch = None,
    json_output: Json = False,
) -> None:
    """Actor Repair F1 of a saved scene against the truth."""
    from c4s.verify.repair import verify_repair
    from c4s.verify.repair.batch import repair_batch

    if batch is not None:
        if start or truth or candidate:
            raise BadInput("give either --batch FILE or the three scenes")
        write_rows(batch, repair_batch)
        return
    _print(
        verify_repair(_given(start, "--input"), _given(truth, "--truth"), _given(candidate, "--candidate")), json_output
    )


@app.command()
def physics(
    snapshot: Annotated[Path, typer.Option(help="snapshot of the saved scene")],
    setting: Annotated[str, typer.Option(help=", ".join(SETTINGS))] = TEXT_TO_SCENE,
    start: Annotated[Path | None, typer.Option("--input", help="snapshot of the start scene (repairs)")] = None,
    json_output: Json = False,
) -> None:
    """Support and penetration of a saved scene."""
    from c4s.verify.physics.verdict import verify_physics

    if setting not in SETTINGS:
        raise unknown("setting", setting, SETTINGS)
    _print(verify_physics(setting, read_snapshot(snapshot), read_snapshot(start) if start else None), json_output)


@app.command()
def support(batch: Annotated[Path, typer.Option("--batch", help="JSON lines (optionally gzip), one row each")]) -> None:
    """The text-to-scene support rule on a batch of scenes."""
    from c4s.verify.physics.batch import support_rows

    write_rows(batch, support_rows)


@app.command()
def navigation(
    snapshot: Annotated[Path, typer.Option(help="snapshot of the saved scene")],
    evidence: Annotated[
        Path | None,
        typer.Option(help="navigation.json of a trial, or what measure_reachability.py wrote; default: measured now"),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="file to write, in the format of measure_reachability.py")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="overwrite a file of this name")] = False,
    json_output: Json = False,
) -> None:
    """Embodied utility of a saved scene, by its own bodies or by a measurement of it."""
    from c4s.navigation import measure_snapshot, published_output, read_published
    from c4s.verify.navigation.verdict import verify_navigation

    if out is not None:
        check_new_file(out)
        check_out(out, replace=replace, magic=b"{")
    scene = read_snapshot(snapshot)
    if evidence is None:
        measured = measure_snapshot(scene)
    else:
        given = read_json(evidence, what="measurement", plain=True)
        published = isinstance(given, Mapping) and "measurement_type" in given
        where = str(evidence)
        measured = (
            read_published(given, scene, where=where) if published else NavigationEvidence.parse(given, where=where)
        )
    if out is not None:
        write_json(out, published_output(measured, scene))
    _print(verify_navigation(measured, scene), json_output)
