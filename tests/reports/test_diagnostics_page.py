"""The page of what stands behind the scores: its bars are its numbers, and what is best in a category is marked."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.reports.watching import watched

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
