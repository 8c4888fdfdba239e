"""``c4s sql`` reads the warehouse and what ``--allow`` opens; it writes no file and loads no extension."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from bench.made_warehouse import MadeWarehouse
from c4s.cli.main import app
from c4s.errors import BadInput

OUTSIDE = (
    "SELECT * FROM read_text('/etc/hostname')",
    "SELECT * FROM read_blob('/etc/hostname')",
    "SELECT * FROM read_csv('/etc/hostname')",
    "SELECT * FROM sniff_csv('/etc/hostname')",
    "SELECT * FROM read_json('/etc/hostname')",
    "SELECT * FROM read_parquet('/etc/hostname')",
    "SELECT * FROM parquet_metadata('/etc/hostname')",
    "SELECT * FROM glob('/etc/*')",
    "SELECT * FROM glob('*')",
    "SELECT * FROM read_text('file:///etc/hostname')",
    "SELECT * FROM read_text('/proc/self/environ')",
    "SELECT * FROM read_text('{home}/secret.csv')",
    "SELECT * FROM read_text('{home}/warehouse/../secret.csv')",
    "SELECT * FROM read_text('{home}/warehouse/linked.csv')",
    "SELECT * FROM query('SELECT * FROM read_text(''/etc/hostname'')')",
    "SELECT * FROM json_execute_serialized_sql(json_serialize_sql('FROM read_text(''/etc/hostname'')'))",
    "FROM read_duckdb('/tmp/other.duckdb')",
    "SELECT * FROM 'http://127.0.0.1:9/rows.csv'",
    "SELECT * FROM 's3://bucket/rows.parquet'",
    "FROM duckdb_secrets()",
)
CHANGING = (
    "COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "EXPLAIN ANALYZE COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "explain (analyze) COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "EXPLAIN (FORMAT json, ANALYZE) COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "EXPLAIN /* a comment */ ANALYZE COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "/* a comment */ EXPLAIN ANALYZE COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "EXPLAIN ANALYZE /* SELECT 1 */ COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "EXPLAIN ANALYZE CREATE TABLE made AS SELECT 1",
    "SELECT 1; COPY (SELECT 1) TO '{home}/warehouse/copied.csv'",
    "ATTACH '{home}/warehouse/other.duckdb'",
    "EXPORT DATABASE '{home}/warehouse/exported'",
    "INSTALL httpfs",
    "LOAD httpfs",
    "LOAD '{home}/warehouse/other.duckdb_extension'",
    "SET enable_external_access = true",
    "SET lock_configuration = false",
    "SET autoinstall_known_extensions = true",
    "RESET allowed_directories",
    "PRAGMA enable_profiling",
    "CREATE SECRET (TYPE s3)",
    "SELECT getenv('HOME')",
    "FROM sqlite_scan('{home}/other.sqlite', 'rows')",
    "FROM postgres_scan('host=127.0.0.1', 'public', 'rows')",
    "FROM enable_logging()",
)


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("home")
    MadeWarehouse(found / "warehouse", (0.7, 0.5)).write()
    (found / "secret.csv").write_text("word\nsesame\n")
    (found / "warehouse/linked.csv").symlink_to(found / "secret.csv")
    return found


def asked(home: Path, *words: str) -> Result:
    return CliRunner(env={"C4S_HOME": str(home)}).invoke(app, ["sql", *words])


def told(done: Result) -> str:
    """The refusal of a command, which answered nothing."""
    assert isinstance(done.exception, BadInput) and not done.stdout, (done.output, done.exception)
    return done.exception.line()


def contents(home: Path) -> dict[str, str]:
    return {str(one): hashlib.sha256(one.read_bytes()).hexdigest() for one in home.rglob("*") if one.is_file()}


@pytest.mark.parametrize("query", OUTSIDE)
def test_no_other_file_is_read(home: Path, query: str) -> None:
    line = told(asked(home, query.format(home=home)))
    assert "reads the warehouse and no other file" in line and "--allow FOLDER" in line and "sesame" not in line


@pytest.mark.parametrize("query", CHANGING)
def test_nothing_is_written_loaded_or_set(home: Path, query: str) -> None:
    asked(home, "SELECT 1")
    before = contents(home)
    told(asked(home, query.format(home=home)))
    assert contents(home) == before


@pytest.mark.parametrize("query", ["EXPLAIN", "EXPLAIN ANALYZE", "explain (analyze)", "EXPLAIN (FORMAT json)"])
def test_a_question_is_explained(home: Path, query: str) -> None:
    done = asked(home, f"{query} SELECT count(*) FROM outcomes")
    assert done.exit_code == 0 and done.stdout


def test_an_allowed_folder_is_read_and_no_other(home: Path, tmp_path: Path) -> None:
    folder = tmp_path / "it's mine"
    folder.mkdir()
    (folder / "rows.csv").write_text("configuration,team\nagent-02,red\n")
    file = str(folder / "rows.csv").replace("'", "''")
    query = f"SELECT DISTINCT team FROM outcomes JOIN '{file}' USING (configuration)"
    assert "--allow" in told(asked(home, query))
    assert asked(home, "--allow", str(folder), "--json", query).stdout == '[{"team": "red"}]\n'
    out = tmp_path / "out.csv"
    asked(home, "--allow", str(folder), "--out", str(out), query)
    assert out.read_text() == "team\nred\n"
    assert "--allow" in told(asked(home, "--allow", str(folder), f"FROM read_text('{home}/secret.csv')"))
    gone = str(folder / "gone.csv").replace("'", "''")
    assert "there is no file" in told(asked(home, "--allow", str(folder), f"FROM '{gone}'"))
    assert "no such folder" in told(asked(home, "--allow", str(folder / "rows.csv"), "SELECT 1"))
    assert "a question only reads" in told(asked(home, "--allow", str(folder), f"COPY (SELECT 1) TO '{gone}'"))
