"""``c4s analyze``: the studies of the paper over the warehouse."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from c4s import extras
from c4s.cli.output import print_json, print_table, say
from c4s.errors import BadInput
from c4s.files import MOST_WHOLE
from c4s.folders import check_new
from c4s.home import analyses_root, warehouse_root

if TYPE_CHECKING:
    from c4s.records.analysis import Findings, StudyResult, Table
    from warehouse.analyses import StudyDefinition

REPLAY = "replay"
MOST_ROWS = 60
"""Rows of a table that are shown; files and JSON have all."""
DIGEST_SHOWN = 12


def analyze(
    name: Annotated[str | None, typer.Argument(help="a study's name, or `replay`")] = None,
    identity: Annotated[str | None, typer.Argument(metavar="[ID]", help="of the answer to replay")] = None,
    agent: Annotated[
        list[str] | None, typer.Option("--agent", "-a", help="configuration; repeatable; `paired` takes two")
    ] = None,
    suite: Annotated[str | None, typer.Option(help="suite, where there are several")] = None,
    build: Annotated[str | None, typer.Option(help="start of the digest of its build (default: the latest)")] = None,
    policy: Annotated[str | None, typer.Option(help="score policy")] = None,
    judge: Annotated[str | None, typer.Option(help="judge")] = None,
    judge_version: Annotated[str | None, typer.Option(help="version of the judge")] = None,
    engine: Annotated[str | None, typer.Option(help="engine")] = None,
    panel: Annotated[str | None, typer.Option(help="public or private cases, where there are both")] = None,
    draws: Annotated[
        int | None, typer.Option(min=100, max=1_000_000, help="resampling draws (default: 10,000)")
    ] = None,
    seed: Annotated[
        int | None,
        typer.Option(min=0, max=MOST_WHOLE, help="seed of the draws (default: the study's own, mostly 23917)"),
    ] = None,
    level: Annotated[
        float | None, typer.Option(min=0.51, max=0.999, help="level of the intervals (default: 0.95)")
    ] = None,
    pool: Annotated[
        list[str] | None,
        typer.Option(
            help="configuration by whose scores cases were selected; repeatable (public-private, set-selection)"
        ),
    ] = None,
    holm: Annotated[bool, typer.Option("--holm", help="adjust p-values for their number (paired, drift)")] = False,
    csv: Annotated[Path | None, typer.Option(help="write the tables as CSV files into this new folder")] = None,
    plot: Annotated[
        Path | None, typer.Option(help="write the charts as SVG, with their data, into this new folder")
    ] = None,
    json_output: Annotated[bool, typer.Option("--json", help="the whole answer as JSON")] = False,
) -> None:
    """Answer a study's question from the warehouse, with intervals that say how they were made.

    Without a name, list the studies. Every answer is kept with its rows: `c4s analyze replay ID` computes it again and
    compares every digit.
    """
    from warehouse.analyses import StudyOptions, WantedScope, answer, folder_of, study_named

    if name is None:
        _list(json_output)
        return
    if name == REPLAY:
        _replay(identity, json_output)
        return
    if identity is not None:
        raise BadInput(f"{identity!r} stands behind the study's name", todo="only `c4s analyze replay` takes an ID")
    study = study_named(name)
    for folder in (csv, plot):
        if folder is not None:
            check_new(folder)
    if csv is not None and csv == plot:
        raise BadInput("tables and charts need a folder each", where=str(csv), todo="--plot another folder")
    if plot is not None:
        extras.need("plots", "--plot")
    given = {"agents": agent, "draws": draws, "seed": seed, "level": level, "pool": pool, "holm": holm or None}
    options = StudyOptions.parse({key: value for key, value in given.items() if value is not None})
    wanted = WantedScope(
        suite=suite,
        suite_digest=build,
        policy=policy,
        judge=judge,
        judge_version=judge_version,
        engine=engine,
        visibility=panel,
    )
    from warehouse.database import catch_up

    catch_up(warehouse_root())
    result = answer(warehouse_root(), study, wanted, options, analyses_root())
    if csv is not None or plot is not None:
        _refuse_private(result.findings)
    written = _write(result, csv, plot)
    if json_output:
        print_json({"id": result.identity(), "written": [str(path) for path in written], **result.plain()})
    else:
        _show(result)
        for path in written:
            say(str(path))
        if plot is not None and (bare := _without_chart(result.findings)):
            say(f"Without a chart: {', '.join(bare)} (what is read as numbers has none).")
        say(f"{result.identity()}: {folder_of(result, analyses_root())}")


def _refuse_private(findings: Findings) -> None:
    """``BadInput`` where tables that go to files, which others may get, name what private cases hold."""
    from warehouse.release import kinds_in, secrets_of, strings_of

    secrets = secrets_of(warehouse_root())
    if kinds := kinds_in("\n".join(strings_of(findings.plain())).encode(), secrets):
        raise BadInput(
            f"these tables tell of private cases ({', '.join(sorted(kinds))}): they are not written to files",
            todo="--panel public; without --csv and --plot they are shown here",
        )


def _write(result: StudyResult, csv: Path | None, plot: Path | None) -> list[Path]:
    """Tables and charts in folders that a user named; beside each chart's picture the table that it shows."""
    from warehouse.analyses.export import write_tables

    findings = result.findings
    written = [] if csv is None else write_tables(findings.tables, csv)
    if plot is not None:
        from reports.charts import write_charts

        written += write_charts(findings, plot, _caption(result))
        shown = {chart.table for chart in findings.charts}
        written += write_tables([table for table in findings.tables if table.name in shown], plot)
    return written


def _caption(result: StudyResult) -> str:
    """What a chart is of, in a line: scope, rows and the level of its intervals."""
    told = [f"{key.replace('_', ' ')} {_named(key, value)}" for key, value in result.scope.items()]
    told += [f"{sum(source.rows for source in result.sources[:1]):,} rows of {result.name}"]
    told += [f"intervals {made.level:.0%}" if made.honest else "no intervals" for made in result.findings.intervals[:1]]
    return ", ".join(told)


def _without_chart(findings: Findings) -> list[str]:
    """The tables with rows that no chart shows."""
    drawn = {chart.table for chart in findings.charts}
    return [table.name for table in findings.tables if table.rows and table.name not in drawn]


def _list(json_output: bool) -> None:
    from warehouse.analyses import STUDIES

    rows = [
        {"name": study.name, "title": study.title, "section": study.section, "takes": _needs(study)}
        for study in STUDIES.values()
    ]
    if json_output:
        print_json(rows)
    else:
        print_table(["study", "title", "in the paper", "takes"], [list(row.values()) for row in rows])


def _needs(study: StudyDefinition) -> str:
    """The options that a study heeds, and the panel where it keeps to one."""
    from warehouse.analyses.study import BOTH_PANELS, RESAMPLING

    told = [f"--{'agent' if name == 'agents' else name}" for name in sorted(study.takes - RESAMPLING)]
    told += ["--draws --seed --level"] if study.takes >= RESAMPLING else []
    told += [] if study.takes >= RESAMPLING or "level" not in study.takes else ["--level"]
    told += [] if study.across & BOTH_PANELS else ["--panel"]
    return " ".join(dict.fromkeys(told))


def _replay(identity: str | None, json_output: bool) -> None:
    from warehouse.analyses import STUDIES, replay

    if identity is None:
        raise BadInput("which answer?", todo="c4s analyze replay ID: the digits that the answer ended with")
    kept, again = replay(analyses_root(), identity, STUDIES)
    same, same_code = kept.findings == again.findings, kept.made_by == again.made_by
    if json_output:
        print_json({"id": kept.identity(), "same": same, "same_code": same_code, **again.plain()})
    else:
        _show(again)
        if not same_code:
            say(f"Other code computed this again: {again.made_by}. The answer was kept by {kept.made_by}.")
        say(f"{kept.identity()}: {'the same to the last digit' if same else 'not what it was'}")
    if not same:
        raise typer.Exit(1)


def _show(result: StudyResult) -> None:
    say(f"{result.title}" + (f" (paper: {result.section})" if result.section else ""), style="bold")
    say(", ".join(f"{key.replace('_', ' ')} {_named(key, value)}" for key, value in result.scope.items()))
    _show_findings(result.findings)


def _named(key: str, value: str) -> str:
    """A name whole, a digest by its first digits."""
    return f"{value[:DIGEST_SHOWN]}…" if key == "suite_digest" else value


def _show_findings(findings: Findings) -> None:
    from warehouse.analyses.tables import method_of

    for table in findings.tables:
        if table.rows:
            say("")
            _show_table(table)
    say("")
    for made in findings.intervals:
        say(method_of(made))
    for note in findings.notes:
        say(note)


def _show_table(table: Table) -> None:
    from warehouse.analyses.tables import marks, printed

    signs = {"best": " **", "second": " *", "": ""}
    columns, marked = [], False
    for column in table.columns:
        found = marks(table, column)
        marked = marked or any(found)
        cells = zip(table.column(column.name), found, strict=True)
        columns.append([_cell(printed(value, column), signs[mark]) for value, mark in cells])
    rows = [list(row) for row in zip(*columns, strict=True)]
    print_table([column.headed() for column in table.columns], rows, title=table.title, most=MOST_ROWS)
    if len(rows) > MOST_ROWS:
        say("All rows: --csv FOLDER or --json")
    if marked:
        apart = any(row.get("ranked") is False for row in table.rows)
        say("** best, * second best of the printed values" + ("; who is not ranked has no mark." if apart else "."))


def _cell(value: object, sign: str) -> object:
    return f"{value}{sign}" if sign else value
