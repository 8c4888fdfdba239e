"""Every kind of page in a browser: no fault, no request that leaves the folder, nothing that axe finds wrong."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Literal

import pytest

from tests.reports.made_site import HOSTILE
from tests.reports.watching import complaints, watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser

KINDS = (
    "index.html",
    "agents/*agent-02*",
    "cases/*text-to-scene-03*",
    "boards/*--cases--*",
    "boards/*--compare--*",
    "boards/*--diagnostics--*",
)


def page_of(home: Path, kind: str) -> Path:
    """The first page of a kind."""
    return next(iter(sorted((home / "site").glob(kind))))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_anybody_can_read_a_page(
    browser: Browser, made_home: Path, kind: str, scheme: Literal["light", "dark"]
) -> None:
    with watched(browser, page_of(made_home, kind), scheme=scheme) as page:
        assert complaints(page) == []


@pytest.mark.parametrize("kind", KINDS)
def test_a_narrow_window_scrolls_down_alone(browser: Browser, made_home: Path, kind: str) -> None:
    with watched(browser, page_of(made_home, kind), width=390) as page:
        assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")


def test_what_would_break_a_page_is_text_on_it(browser: Browser, made_home: Path) -> None:
    with watched(browser, page_of(made_home, "cases/*text-to-scene-03*")) as page:
        assert HOSTILE.replace("\u202e", "") in page.inner_text("h1").replace("\ufffd", "")
        assert page.locator("script:not([src])").count() == 0


def test_pages_are_small(made_home: Path) -> None:
    sizes = {path.name: path.stat().st_size for path in (made_home / "site").rglob("*.html")}
    assert sizes["index.html"] < 500_000 and max(sizes.values()) < 3_000_000
