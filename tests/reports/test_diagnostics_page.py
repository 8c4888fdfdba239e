"""The page of what stands behind the scores: its bars are its numbers, and what is best in a category is marked."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from c4s.protocol.baselines import NOOP
from reports.site import build_site
from tests.reports.watching import watched
from warehouse.database import rebuild

if TYPE_CHECKING:
    from playwright.sync_api import Browser


def diagnostics(home: Path) -> Path:
    """The page."""
    return next((home / "site" / "boards").glob("*--diagnostics--*"))


def test_bars_are_as_long_as_their_numbers_say(browser: Browser, made_home: Path) -> None:
    with watched(browser, diagnostics(made_home)) as page:
        rows = page.locator("#spatial table.bars tbody tr")
        assert rows.count() >= 8, "four kinds with all of them, and the complete configurations"
        for row in rows.all():
            count, of = (int(word) for word in row.locator("td.r").inner_text().split(" · ")[0].split(" of "))
            length = float(str(row.locator("rect.mismatched").get_attribute("width")))
            assert length == pytest.approx(100 * count / of, abs=0.01)
        for row in page.locator("#repairs table.bars tbody tr:has(rect.clean)").all():
            clean, _, spoilt, _, of = row.locator("td.r").inner_text().split()
            parts = [float(str(row.locator(f"rect.{kind}").get_attribute("width"))) for kind in ("clean", "spoilt")]
            assert parts == pytest.approx([100 * int(clean) / int(of), 100 * int(spoilt) / int(of)], abs=0.01)


def test_a_category_marks_its_best_of_four(browser: Browser, made_home: Path) -> None:
    with watched(browser, diagnostics(made_home)) as page:
        tables = page.locator(".small-multiples table").all()
        assert len(tables) == 5
        for table in tables:
            scores = [float(text) for text in table.locator("td.r").all_inner_texts()]
            best = float(table.locator("tr.best td.r").first.inner_text())
            assert len(scores) == 4 and best == max(scores)


def test_a_reader_is_told_why_there_is_no_navigation(browser: Browser, made_home: Path) -> None:
    with watched(browser, diagnostics(made_home), fragment="#navigation") as page:
        assert (
            "Not evaluated: no trial of this leaderboard has a navigation verdict"
            in page.locator("#navigation").inner_text()
        )
        assert page.locator("#behaviour table.bars").count() == 3 and page.locator("#firmness table").count() == 3


def test_panels_of_navigation_are_shown_where_trials_were_walked(browser: Browser, played_home: Path) -> None:
    with watched(browser, diagnostics(played_home), fragment="#navigation") as page:
        section = page.locator("#navigation")
        assert "Not evaluated" not in section.inner_text()
        panel = section.locator("table[data-name=panel_text_to_scene]")
        assert panel.locator("tr[data-configuration=oracle] td.r").first.inner_text() != ""
        assert "No change against the matched input" in section.inner_text(), "nobody played noop"


def test_changes_against_the_input_are_bars_to_both_sides_of_no_change(
    browser: Browser, played_home: Path, tmp_path: Path
) -> None:
    """``random`` stands for the one that does nothing: what it saved is the input."""
    shutil.copytree(played_home / "warehouse", tmp_path / "warehouse", ignore=shutil.ignore_patterns("*.duckdb"))
    for path in tmp_path.glob("warehouse/*/**/configuration=random/**/*.parquet"):
        table = pq.ParquetFile(path).read()
        if "client" in table.column_names:
            place = table.column_names.index("client")
            noop = pa.array([NOOP] * table.num_rows, table.schema.field(place).type)
            pq.write_table(table.set_column(place, table.schema.field(place), noop), path)
    rebuild(tmp_path / "warehouse")
    build_site(tmp_path / "warehouse", tmp_path / "site")
    with watched(browser, diagnostics(tmp_path), fragment="#navigation") as page:
        section = page.locator("#navigation")
        bars = section.locator("table.bars tbody tr")
        assert bars.count() >= 2 and not section.locator("tr[data-configuration=random] rect").count()
        told = {}
        for row in bars.all():
            change = float(row.locator("td.r").inner_text().split()[0])
            part = row.locator("rect").last
            start, width = (float(str(part.get_attribute(name))) for name in ("x", "width"))
            told[row.get_attribute("data-configuration")] = change
            assert start + width == pytest.approx(50, abs=0.01) if change < 0 else start == pytest.approx(50, abs=0.01)
        rows = section.locator("table[data-name^=change_] tbody tr")
        tabled = {row.get_attribute("data-configuration"): row.locator("td.r").first.inner_text() for row in rows.all()}
        assert {name: float(text) for name, text in tabled.items()} == pytest.approx(told, abs=0.0006)
