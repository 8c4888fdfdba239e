"""The warehouse as one folder that others can take: one sorted file a table, with what each is made of."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Final, Literal

import pyarrow as pa
import pyarrow.parquet as pq

from c4s.files import digest_file, write_text
from c4s.folders import beside, put_folder
from c4s.records.base import Record
from c4s.records.version import code_version
from warehouse.database import arrow
from warehouse.parquet import arrow_schema
from warehouse.parts import HELD
from warehouse.records import TABLES
from warehouse.release.leaks import refuse_leaks
from warehouse.release.panel import PrivateStanding, private_standings
from warehouse.release.secrets import PUBLIC, secrets_of

MANIFEST: Final = "warehouse.json"
PANEL: Final = "private_panel"
CALLS: Final = "calls"
"""The one table outside the database that every download has."""
ROW_GROUP: Final = 250_000
"""Rows that are read at once: between the 100,000 and 1,000,000 that DuckDB's guide to file formats advises."""
PICTURE_ROWS: Final = 256
ALL: Final = tuple(name for name, model in TABLES.items() if "case_id" in model.model_fields)
"""Tables of cases: the shapes of packs come with the packs."""
_ORDER: Final = ("suite", "suite_digest", "configuration", "configuration_digest", "setting", "case_id", "repeat")
_LAST: Final = ("policy", "judge", "judge_version", "engine", "trial_id", "attempt", "call", "verifier", "name", "tool")
_ENDS: Final = ("outcome", "subject", "detail", "role", "view")


class DownloadTable(Record):
    """A table of a download: its one file."""

    name: str
    file: str
    file_sha256: str
    rows: int
    bytes: int
    sorted_by: list[str]
    columns: dict[str, str]
    """Arrow type of each, by its name."""


class Download(Record):
    """What lies beside the tables of a download."""

    schema_version: Literal["c4s.download.v1"] = "c4s.download.v1"
    code: str
    """Version of the code that wrote it."""
    tables: list[DownloadTable]
    private: str = ""
    """What is told of private cases."""


def write_download(warehouse: Path, place: Path, *, pictures: bool = False, suites: Path | None = None) -> Download:
    """Write every table as one zstd Parquet file, sorted by configuration and case, with a manifest of digests.

    Rows of private cases are left out; what is told of them is the table ``private_panel``. The folder is looked
    through for what they hold before it is there.

    Args:
        warehouse: the warehouse, brought up to its parts.
        place: a new folder, or one of an earlier download, which is replaced.
        pictures: whether the pictures and scenes of public cases are written too.
        suites: where suites lie (``secrets_of``).

    Raises:
        BadInput: something else lies at ``place``.
        MachineryFault: something of a private case stands in what would be published.
    """
    secrets = secrets_of(warehouse, suites)
    standings = private_standings(warehouse)
    with beside(place) as scratch:
        made = scratch / place.name
        made.mkdir()
        tables = [_write(made, name, *_public(warehouse, name)) for name in (ALL if pictures else (*HELD, CALLS))]
        if standings:
            tables.append(_write(made, PANEL, _panel(standings), ["suite", "suite_digest", "configuration"]))
        told = f"means over all private cases in {PANEL}.parquet, nothing else" if standings else ""
        download = Download(code=code_version("records"), tables=tables, private=told)
        write_text(made / MANIFEST, download.model_dump_json(indent=1) + "\n")
        refuse_leaks(made, secrets)
        put_folder(made, place, marker=MANIFEST)
    return download


def _public(warehouse: Path, table: str) -> tuple[pa.Table, list[str]]:
    """The rows of public cases, and what they are sorted by."""
    names = arrow_schema(table).names
    order = [name for name in (*_ORDER, *_LAST, *_ENDS) if name in names]
    public = f"SELECT suite, suite_digest, case_id FROM schedule WHERE visibility = '{PUBLIC}'"
    where = f"(suite, suite_digest, case_id) IN ({public})"
    rows = arrow(warehouse, f"SELECT * FROM {table} WHERE {where} ORDER BY {', '.join(order)}")
    return rows.cast(arrow_schema(table)), order


def _panel(standings: Sequence[PrivateStanding]) -> pa.Table:
    return pa.Table.from_pylist([row.plain() for row in standings])


def _write(folder: Path, name: str, rows: pa.Table, order: list[str]) -> DownloadTable:
    path = folder / f"{name}.parquet"
    group = PICTURE_ROWS if name not in (*HELD, CALLS) else ROW_GROUP
    sorting = pq.SortingColumn.from_ordering(rows.schema, [(one, "ascending") for one in order])
    pq.write_table(rows, path, compression="zstd", row_group_size=group, sorting_columns=sorting, write_page_index=True)
    return DownloadTable(
        name=name,
        file=path.name,
        file_sha256=digest_file(path),
        rows=len(rows),
        bytes=path.stat().st_size,
        sorted_by=order,
        columns={field.name: str(field.type) for field in rows.schema},
    )
