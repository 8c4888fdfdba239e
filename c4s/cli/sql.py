"""``c4s sql``: ask the warehouse."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import check_new_file, print_json, print_table, say
from c4s.errors import BadInput, unknown
from c4s.files import read_plain_text
from c4s.home import warehouse_root


def sql(
    query: Annotated[str | None, typer.Argument(help="SQL, a question's name, or a .sql file")] = None,
    out: Annotated[Path | None, typer.Option(help="write the rows to a .csv, .parquet or .xlsx file")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="overwrite a file of this name")] = False,
    allow: Annotated[
        list[Path] | None, typer.Option(help="a folder of yours whose files the query may read; again for another")
    ] = None,
    shell: Annotated[
        bool, typer.Option("--shell", help="ask one question after another; without a terminal, read a script")
    ] = False,
    json_output: Annotated[bool, typer.Option("--json", help="rows as a JSON array")] = False,
) -> None:
    """Ask the warehouse in SQL. Without a query, list the named questions.

    Rows that came since the last answer are taken in first, those of a run at work too.
    """
    from warehouse.database import ask, catch_up, held_open, questions
    from warehouse.records import TABLES

    if shell:
        if query is not None or out is not None or allow or json_output:
            raise BadInput("--shell asks for nothing else", todo="c4s sql --shell")
        from c4s.cli.shell import run_shell

        catch_up(warehouse_root())
        raise typer.Exit(run_shell())
    if query is None and out is not None:
        raise BadInput("--out needs a query", todo="c4s sql leaderboard --out leaderboard.csv")
    if query is None:
        if json_output:
            print_json(questions())
        else:
            say(f"Questions: {', '.join(questions())}")
            say(f"Tables: {', '.join(TABLES)}")
            say("Try: c4s sql leaderboard")
        return
    where = "query"
    if query in questions():
        text = f"SELECT * FROM {query}"
    elif query.endswith(".sql"):
        text, where = read_plain_text(Path(query)), query
    elif re.fullmatch(r"[\w.-]+", query):
        raise unknown("question", query, questions(), todo='or ask in SQL: "SELECT * FROM outcomes"')
    else:
        text = query
    catch_up(warehouse_root())
    if out is not None:
        from warehouse.frames import export

        check_new_file(out)
        sheet = query if query in questions() else "rows"
        with held_open(warehouse_root(), allow or ()):
            count = export(warehouse_root(), text, out, replace=replace, where=where, name=sheet)
        print_json({"file": str(out), "rows": count}) if json_output else say(f"{count} rows: {out}")
        return
    with held_open(warehouse_root(), allow or ()):
        columns, rows = ask(warehouse_root(), text, where=where)
    if json_output:
        print_json([dict(zip(columns, row, strict=True)) for row in rows])
    else:
        print_table(columns, rows)
