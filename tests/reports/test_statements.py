"""Statement pages: what they take from registries and from the warehouse, and that everybody can read them."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import TYPE_CHECKING

from c4s.files import digest_bytes
from c4s.protocol.rules import I2S_WEIGHTS, T2S_WEIGHTS
from reports.frame import links
from reports.statements import RELATED, weight_tables
from tests.reports.watching import watched
from warehouse.records import TABLES

if TYPE_CHECKING:
    from playwright.sync_api import Browser

STATEMENTS = (links.ABOUT, links.LIMITS, links.CHEATS, links.METHODS, links.RELATED, links.DATA, links.RELEASE)


def test_every_statement_leads_to_the_others(made_home: Path) -> None:
    for path in STATEMENTS:
        tabs = (made_home / "site" / path).read_text().partition('class="tabs"')[2].partition("</nav>")[0]
        assert all(f'href="{other}"' in tabs for other in STATEMENTS)


def test_weights_are_those_of_the_policy(browser: Browser, made_home: Path) -> None:
    (told,) = weight_tables(["code4scene-published", "code4scene-published", "nosuch"])
    assert [table.rows for table in told.tables[:2]] == [T2S_WEIGHTS, I2S_WEIGHTS]
    assert "5 cm, 5 degrees and 5.0%" in told.tolerances
    with watched(browser, made_home / "site" / links.ABOUT) as page:
        shown = page.inner_text(".weights table >> nth=0").split()
    assert shown[-6:] == [word for name, weight in T2S_WEIGHTS.items() for word in (name, f"{weight:.2f}")]


def test_downloads_are_what_the_page_says(browser: Browser, made_home: Path) -> None:
    with watched(browser, made_home / "site" / links.DATA) as page:
        rows = page.locator("table").first.locator("tbody tr").all()
        for row in rows:
            file = made_home / "site" / str(row.locator("a").get_attribute("href"))
            data = file.read_bytes()
            assert digest_bytes(data) == row.locator("code").inner_text()
            lines = list(csv.DictReader(data.decode().splitlines()))
            assert {line["visibility"] for line in lines} <= {"public"}
        assert len(rows) == 4
        assert {table.inner_text() for table in page.locator("section h3 code").all()} == set(TABLES)


def test_only_this_benchmark_claims_everything() -> None:
    assert len(RELATED) == 8 and len({row.name for row in RELATED}) == 8
    assert max(RELATED, key=lambda row: len(row.covers)).name == "Code4Scene"
