"""``c4s sql``: ask the warehouse."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json, print_table
from c4s.errors import BadInput
from c4s.home import warehouse_root


def sql(
    query: Annotated[str | None, typer.Argument(help="SQL, a question's name, or a .sql file")] = None,
    out: Annotated[Path | None, typer.Option(help="write the rows to a .csv or .parquet file")] = None,
    json_output: Annotated[bool, typer.Option("--json", help="rows as a JSON array")] = False,
) -> None:
    """Ask the warehouse in SQL. Without a query, list the named questions."""
    from warehouse.database import ask, questions
    from warehouse.records import TABLES

    if query is None:
        if json_output:
            print_json(questions())
        else:
            print(f"Questions: {', '.join(questions())}\nTables: {', '.join(TABLES)}\nTry: c4s sql leaderboard")
        return
    if query in questions():
        text = f"SELECT * FROM {query}"
    elif query.endswith(".sql"):
        if not Path(query).is_file():
            raise BadInput("no such file", where=query)
        text = Path(query).read_text()
    else:
        text = query
    if out is not None:
        from warehouse.frames import export

        count = export(warehouse_root(), text, out)
        print_json({"file": str(out), "rows": count}) if json_output else print(f"{count} rows: {out}")
        return
    columns, rows = ask(warehouse_root(), text)
    if json_output:
        print_json([dict(zip(columns, row, strict=True)) for row in rows])
    else:
        print_table(columns, rows)
