"""Pages on paper: nothing is cut off, nothing is dark, what is folded is open, and what moves is a picture."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Final

import pytest

from tests.reports.kinds import KINDS
from tests.reports.watching import watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

MM: Final = 96 / 25.4
PORTRAIT, LANDSCAPE = round((210 - 2 * 13) * MM), round((297 - 2 * 11) * MM)
"""Pixels that a line of A4 has between the margins of ``print.css``."""
FOLDED = """() => Array.from(document.querySelectorAll("details"), (one) => {
  const walker = document.createTreeWalker(one, NodeFilter.SHOW_TEXT);
  const texts = [];
  while (walker.nextNode()) texts.push(walker.currentNode.data);
  return texts.join(" ");
}).join(" ")"""
BEYOND = """() => Array.from(document.querySelectorAll("main *")).filter((one) =>
  one.checkVisibility() && !one.closest(".unseen, svg") && one.getBoundingClientRect().right > innerWidth + 1
).map((one) => one.outerHTML.slice(0, 100))"""
WIDE = "all => all.forEach((one) => one.style.setProperty('min-width', '90px', 'important'))"
WORDS = re.compile(r"[A-Za-z]{5,}")


def pdf_text(page: Page, place: Path) -> str:
    """The text of the page as the browser prints it."""
    if shutil.which("pdftotext") is None:
        pytest.skip("no pdftotext (poppler-utils) on this machine")
    page.pdf(path=place, prefer_css_page_size=True)
    return subprocess.run(["pdftotext", "-raw", place, "-"], check=True, capture_output=True, text=True).stdout


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_cut_off_or_dark(browser: Browser, page_of: Callable[[str], Path], kind: str) -> None:
    width = LANDSCAPE if kind in ("leaderboard", "cases") else PORTRAIT
    with watched(browser, page_of(kind), scheme="dark", width=width) as page:
        page.emulate_media(media="print")
        assert page.evaluate(BEYOND) == []
        assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
        assert page.locator("nav:visible, select:visible, input:visible, .stage:visible, canvas:visible").count() == 0
        for place in page.locator(".scroll, .prompt, .text").all():
            assert place.evaluate("one => getComputedStyle(one).overflowY") == "visible"


@pytest.mark.parametrize("kind", ["trial-text", "trial-repair", "compare", "case-repair", "data", "status"])
def test_what_is_folded_is_on_paper(
    browser: Browser, page_of: Callable[[str], Path], kind: str, tmp_path: Path
) -> None:
    with watched(browser, page_of(kind)) as page:
        folded = set(WORDS.findall(page.evaluate(FOLDED)))
        printed = set(WORDS.findall(pdf_text(page, tmp_path / "page.pdf")))
    assert len(folded - printed) <= 0.05 * len(folded), sorted(folded - printed)
    assert printed


def test_a_cut_table_is_seen(browser: Browser, page_of: Callable[[str], Path]) -> None:
    with watched(browser, page_of("cases"), width=PORTRAIT) as page:
        page.emulate_media(media="print")
        page.eval_on_selector_all("td", WIDE)
        assert page.evaluate(BEYOND) != []
