"""What is published of a warehouse with private cases: sums by an allow-list, and no planted word of them anywhere."""

from __future__ import annotations

import base64
import bz2
import gzip
import html
import io
import json
import lzma
import random
import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path
from urllib.parse import quote

import duckdb
import numpy as np
import openpyxl
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from jinja2 import ChoiceLoader, DictLoader
from PIL import Image

from bench.made_warehouse import PUBLIC_SET, MadeWarehouse
from c4s.errors import BadInput, MachineryFault
from c4s.protocol.settings import OUTDOOR_REPAIR
from c4s.records.suite import Suite, SuiteCase, SuiteFolder
from reports.site import build, build_site
from warehouse.database import rebuild, rows
from warehouse.parquet import write_part
from warehouse.records import FindingRow, PictureRow, VerdictRow
from warehouse.release import (
    PrivateStanding,
    Secrets,
    leaks_in,
    private_standings,
    refuse_leaks,
    secrets_of,
    write_download,
)

PRIVATE = frozenset(
    f"{setting.rpartition('/')[2]}-{place:02d}"
    for setting, count, _ in PUBLIC_SET
    for place in range(count - 6, count + 1)
    for setting, count, _ in PUBLIC_SET
    for place in range(count - 6, count + 1)
)
PROMPT = 'Put the crimson lighthouse beside the "old" harbour & paint seven zebra crossings'
REQUIREMENT = "the lighthouse stands <north> of a quay"
ACTOR = "SM_Lighthouse_Crimson_07"
ASSET = "/Game/Hidden/Harbour/SM_Quay_Piece"
HIDDEN, VERIFIER = "outdoor-50", "repair"


def jpeg(seed: int) -> bytes:
    out = io.BytesIO()
    noise = np.random.default_rng(seed).integers(0, 255, (64, 64, 3), dtype=np.uint8)
    Image.fromarray(noise).save(out, "JPEG", quality=95)
    return out.getvalue()


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two configurations on both panels; the last outdoor case is private and has texts and a picture of its own."""
    made = MadeWarehouse(tmp_path_factory.mktemp("home") / "warehouse", (0.7, 0.5), private=PRIVATE)
    made.write()
    for path in (made.root / "schedule").rglob("*.parquet"):
        table = pq.ParquetFile(path).read()
        prompts = [PROMPT if case == HIDDEN else "A yard." for case in table["case_id"].to_pylist()]
        pq.write_table(
            table.set_column(table.column_names.index("prompt"), table.schema.field("prompt"), [prompts]), path
        )
    rebuild(made.root)
    for case, seed in ((HIDDEN, 1), ("outdoor-01", 2)):
        (row,) = rows(made.root, f"SELECT * FROM schedule WHERE case_id = '{case}' AND configuration = 'agent-01'")
        key = {name: row[name] for name in FindingRow.model_fields if name in row}
        document = {"population": {}, "advisories": [], "seen": [ASSET if case == HIDDEN else "/Game/Yard/SM_Gate"]}
        texts = (ACTOR, REQUIREMENT) if case == HIDDEN else ("SM_Gate_01", "a gate is open")
        parts = {
            "findings": [
                FindingRow(**key, verifier=VERIFIER, subject=subject, outcome="FP", detail="") for subject in texts
            ],
            "verdicts": [
                VerdictRow(
                    **key,
                    verifier=VERIFIER,
                    status="measured",
                    score=0.5,
                    reason="",
                    policy="p",
                    document=json.dumps(document),
                    verdict_sha256="0",
                )
            ],
            "pictures": [PictureRow(**key, role="submission", view="overview", width=64, height=64, jpeg=jpeg(seed))],
        }
        for table, found in parts.items():
            write_part(made.root, table, found, suite="made", configuration="agent-01", key=case)
    rebuild(made.root)
    return made.root


@pytest.fixture(scope="module")
def secrets(root: Path) -> Secrets:
    return secrets_of(root)


@pytest.fixture(scope="module")
def published(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site and the download."""
    folder = tmp_path_factory.mktemp("published")
    build_site(root, folder / "site")
    write_download(root, folder / "download", pictures=True)
    return folder


def test_nothing_of_private_cases_is_published(published: Path, secrets: Secrets) -> None:
    assert {"case", "trial", "title", "prompt", "finding", "verdict"} <= set(secrets.pieces.values())
    assert len(secrets.pictures) == 1
    assert leaks_in(published, secrets) == []
    names = " ".join(path.name for path in published.rglob("*"))
    assert "outdoor-01" in names and not any(case in names for case in PRIVATE)
    page = (published / "site" / "index.html").read_text()
    assert "Private cases" in page and "agent-01" in page
    assert len(list((published / "site" / "pictures").iterdir())) == 1


def test_the_private_panel_is_told_by_its_means(root: Path, published: Path) -> None:
    standings = private_standings(root)
    assert [row.rank for row in standings] == [1, 2]
    table = pq.ParquetFile(published / "download" / "private_panel.parquet").read()
    assert table.column_names == list(PrivateStanding.model_fields)
    ((mean,),) = [
        tuple(row.values())
        for row in rows(
            root,
            "SELECT avg(score) AS m FROM case_scores JOIN settings USING (setting) "
            "WHERE construction AND visibility = 'private' AND configuration = 'agent-01'",
        )
    ]
    assert standings[0].text_to_scene == pytest.approx(mean, abs=1e-12)


def test_the_allow_list_has_no_name_of_a_case() -> None:
    """A field that is added here has to be a mean or a count over all private cases."""
    named = {"case_id", "scene_id", "title", "prompt", "trial_id", "reason", "operations", "difficulty", "run_id"}
    assert not named & set(PrivateStanding.model_fields)


def test_a_mean_over_few_cases_is_not_told(tmp_path: Path) -> None:
    few = MadeWarehouse(tmp_path, (0.7, 0.5), private=frozenset({"indoor-01", "indoor-02"}))
    few.write()
    for row in private_standings(tmp_path):
        assert (row.indoor, row.rank, row.planned) == (None, None, 2)


def test_a_download_is_the_public_rows_sorted(root: Path, published: Path) -> None:
    folder = published / "download"
    manifest = json.loads((folder / "warehouse.json").read_text())
    files = {table["file"] for table in manifest["tables"]}
    assert files | {"warehouse.json"} == {path.name for path in folder.iterdir()}
    outcomes = pq.ParquetFile(folder / "outcomes.parquet").read().to_pylist()
    wanted = rows(
        root, "SELECT o.* FROM outcomes AS o JOIN schedule AS s USING (trial_id) WHERE s.visibility = 'public'"
    )
    order = ("configuration", "setting", "case_id")
    assert outcomes == sorted(wanted, key=lambda row: [row[name] for name in order])
    again = write_download(root, folder.with_name("again"), pictures=True)
    assert [table.file_sha256 for table in again.tables] == [table["file_sha256"] for table in manifest["tables"]]


def test_no_other_folder_is_taken_for_a_download(root: Path, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "notes.txt").write_text("mine")
    with pytest.raises(BadInput, match="did not make"):
        write_download(root, tmp_path / "mine")


def test_a_leak_is_told_by_its_file_and_kind(tmp_path: Path, secrets: Secrets) -> None:
    (tmp_path / "notes.md").write_text(f"see {HIDDEN}")
    with pytest.raises(MachineryFault, match=r"case in notes\.md") as caught:
        refuse_leaks(tmp_path, secrets)
    assert HIDDEN not in caught.value.line()


def test_a_page_that_is_made_with_a_private_text_is_not_written(
    root: Path, published: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever a template brings onto a page, by a row that it should not have read, ends the build."""
    site = Path(shutil.copytree(published / "site", tmp_path / "site"))
    before = {path: path.read_bytes() for path in site.rglob("*") if path.is_file()}
    made = build.environment().overlay()
    page = "{% for word in words %}<b>{{ word }}</b>&nbsp;{% endfor %}"
    made.loader = ChoiceLoader([DictLoader({"configuration.html.j2": page}), made.loader])
    made.cache = {}
    made.globals = {**made.globals, "words": PROMPT.split()}
    monkeypatch.setattr(build, "environment", lambda: made)
    monkeypatch.setattr(build, "code_digest", lambda: "of other templates")
    with pytest.raises(MachineryFault, match=r"prompt in agents/") as caught:
        build_site(root, site)
    assert "lighthouse" not in caught.value.line()
    assert {path: path.read_bytes() for path in site.rglob("*") if path.is_file()} == before


def test_files_of_a_suite_tell_more_of_its_private_cases(root: Path, tmp_path: Path) -> None:
    """Aliases, requirements and pictures that no row has."""
    suites = tmp_path / "suites"
    folder = SuiteFolder(suites / "made")
    digests = {"agent_digest": "0" * 64, "withheld_digest": "0" * 64}
    cases = [
        SuiteCase(case_id=case, alias=alias, setting=OUTDOOR_REPAIR, **digests)
        for case, alias in ((HIDDEN, "blue-heron-77"), ("outdoor-01", "red-robin-12"))
    ]
    for case, hint in zip(cases, ("a silver weathercock on top", "a gate is open"), strict=True):
        for place in (folder.withheld(case.case_id), folder.agent(case.alias)):
            place.mkdir(parents=True)
            (place / "case.json").write_text(json.dumps({"hint": [hint]}))
        (folder.agent(case.alias) / "start.jpg").write_bytes(jpeg(5 if case.case_id == HIDDEN else 6))
    Suite(suite_id="made", title="", packs=[], cases=cases).write(folder.record)
    alone, both = secrets_of(root), secrets_of(root, suites)
    published = tmp_path / "published"
    published.mkdir()
    for kind, data in (
        ("alias", b"see blue-heron-77.html"),
        ("file of the suite", b"A silver\nweathercock ON TOP!"),
        ("picture", jpeg(5)),
    ):
        (published / "file").write_bytes(data)
        assert leaks_in(published, alone) == []
        assert [leak.kind for leak in leaks_in(published, both)] == [kind]
    (published / "file").write_bytes(b"new Lathe(a silver weathercock on top)")
    assert (
        leaks_in(published, both)
        and leaks_in(published, secrets_of(root, suites, ["a Silver Weathercock on top"])) == []
    )
    for data in (b"see red-robin-12.html: a gate is open", jpeg(6)):
        (published / "file").write_bytes(data)
        assert leaks_in(published, both) == []


LABELS = ("<td>SM_Lighthouse_Crimson_07</td>", "sm-lighthouse-crimson-07", "SM_Light\u200bhouse_Crimson_0\u00ad7")
NO_LABELS = ("<td>SM_Lighthouse_Crimson</td><td>07.2 cm</td>", "SM_Lighthouse_Crimson&#07;")
WORDS = (
    "the lighthouse stands north of <a href='x'>a</a>",
    "lighthouse stands north of a <quay id='x'>",
    "<img alt='the lighthouse stands north of a'>",
    "<SM_Lighthouse_Crimson_07 id='x'>",
)
NO_WORDS = ("<a>the lighthouse stands north of</a>", r"\u0061 &amp; the lighthouse stands north of <a id='x'>")


@pytest.mark.parametrize("text", LABELS + NO_LABELS + WORDS + NO_WORDS)
def test_neither_a_number_in_the_next_cell_nor_a_tag_is_a_word(text: str, secrets: Secrets, tmp_path: Path) -> None:
    (tmp_path / "file").write_text(text)
    assert bool(leaks_in(tmp_path, secrets)) is (text in LABELS + WORDS)


def test_pages_are_not_made_of_a_damaged_warehouse(tmp_path: Path) -> None:
    """A leaderboard whose study cannot be asked is told, and not shown as one without intervals."""
    made = MadeWarehouse(tmp_path / "warehouse", (0.7, 0.5))
    made.write()
    page = build_site(made.root, tmp_path / "site")
    before = page.read_bytes()
    with duckdb.connect(str(made.root / "c4s.duckdb")) as connection:
        connection.execute("DROP VIEW components")
    with pytest.raises(BadInput, match="components"):
        build_site(made.root, tmp_path / "site")
    assert page.read_bytes() == before


def as_workbook(text: str) -> bytes:
    book, out = openpyxl.Workbook(), io.BytesIO()
    book.active.append(["text", text])
    book.save(out)
    return out.getvalue()


def as_parquet(text: str) -> bytes:
    out = io.BytesIO()
    pq.write_table(pa.table({"a": [1, 2], "b": [["x"], [text]]}), out, compression="zstd")
    return out.getvalue()


def as_zip(text: str) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("inner.html", html.escape(text))
    return out.getvalue()


HIDINGS: dict[str, Callable[[str], bytes]] = {
    "plain": str.encode,
    "html": lambda text: f"<td>{html.escape(text)}</td>".encode(),
    "html numbers": lambda text: "".join(f"&#{ord(one)};" for one in text).encode(),
    "json": lambda text: json.dumps({"x": [text]}).encode(),
    "json in html": lambda text: html.escape(json.dumps(text)).encode(),
    "json numbers": lambda text: "".join(f"\\u{ord(one):04x}" for one in text).encode(),
    "address": lambda text: f"<a href='x/{quote(text, safe='')}'>".encode(),
    "lines": lambda text: text.replace(" ", "\n    ").encode(),
    "capitals": lambda text: text.upper().encode(),
    "marked": lambda text: html.escape(text).replace(" ", " <b></b>").encode(),
    "utf-16": lambda text: text.encode("utf-16"),
    "base64": lambda text: base64.b64encode(f"{text} {'.' * 64}".encode()),
    "gzip": lambda text: gzip.compress(text.encode()),
    "zip": as_zip,
    "xlsx": as_workbook,
    "parquet": as_parquet,
}


@pytest.mark.parametrize("hiding", HIDINGS)
def test_each_kind_is_found_however_it_is_hidden(hiding: str, secrets: Secrets, root: Path, tmp_path: Path) -> None:
    (trial,) = rows(root, f"SELECT trial_id FROM schedule WHERE case_id = '{HIDDEN}' AND configuration = 'agent-02'")
    planted = {
        "case": HIDDEN,
        "trial": trial["trial_id"],
        "title": "Made outdoor 50",
        "prompt": " ".join(PROMPT.split()[2:8]),
        "finding": REQUIREMENT,
        "actor": ACTOR,
        "verdict": ASSET,
    }
    for kind, text in planted.items():
        (tmp_path / "file").write_bytes(HIDINGS[hiding](text))
        assert leaks_in(tmp_path, secrets), kind
    (tmp_path / "file").write_bytes(HIDINGS[hiding]("outdoor-01: Made outdoor 1, A yard., SM_Gate_01, the outdoor 50"))
    assert leaks_in(tmp_path, secrets) == []


def test_a_picture_is_found_alone_inside_and_encoded(secrets: Secrets, tmp_path: Path) -> None:
    column = io.BytesIO()
    pq.write_table(pa.table({"jpeg": [jpeg(2), jpeg(1)]}), column)
    for data in (
        jpeg(1),
        b"head" + jpeg(1) + b"tail",
        b"<img src='data:image/jpeg;base64," + base64.b64encode(jpeg(1)) + b"'>",
        column.getvalue(),
    ):
        (tmp_path / "file").write_bytes(data)
        assert [leak.kind for leak in leaks_in(tmp_path, secrets)] == ["picture"]
    (tmp_path / "file").write_bytes(jpeg(2))
    assert leaks_in(tmp_path, secrets) == []


def test_names_of_files_and_databases_are_looked_at(secrets: Secrets, root: Path, tmp_path: Path) -> None:
    (tmp_path / f"made--{HIDDEN}--1a2b.html").write_text("")
    (tmp_path / "rows.duckdb").write_bytes((root / "c4s.duckdb").read_bytes())
    assert {"case", "database"} <= {leak.kind for leak in leaks_in(tmp_path, secrets)}


def nested(data: bytes, times: int) -> bytes:
    for _ in range(times):
        data = gzip.compress(data)
    return data


@pytest.mark.parametrize(
    "data",
    [
        b"\x1f\x8b\x08cut off",
        b"PK\x03\x04cut off",
        b"PAR1cut off",
        as_parquet("a yard")[:-20] + b"PAR1",
        gzip.compress(b"a yard")[:-6],
        lzma.compress(HIDDEN.encode()),
        bz2.compress(HIDDEN.encode()),
        nested(HIDDEN.encode(), 9),
    ],
)
def test_what_cannot_be_looked_through_is_told(data: bytes, secrets: Secrets, tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(data)
    assert [leak.kind for leak in leaks_in(tmp_path, secrets)] == ["unreadable"]
    (tmp_path / "file").write_bytes(nested(b"a yard", 4))
    assert leaks_in(tmp_path, secrets) == []


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(seed=st.integers(0, 2**32), hidings=st.lists(st.sampled_from(sorted(HIDINGS)), min_size=1, max_size=1))
def test_any_piece_is_found_in_the_midst_of_a_page(
    seed: int, hidings: list[str], secrets: Secrets, published: Path, tmp_path: Path
) -> None:
    chance = random.Random(seed)
    piece = chance.choice(sorted(secrets.pieces))
    page = (published / "site" / "index.html").read_text()
    at = chance.randrange(len(page))
    text = piece.replace(" ", "-") if piece in secrets.joined else piece
    for hiding in hidings:
        whole = text if hiding in ("xlsx", "parquet", "base64", "address") else f"{page[:at]} {text} {page[at:]}"
        (tmp_path / "file").write_bytes(HIDINGS[hiding](whole))
        assert leaks_in(tmp_path, secrets)
