"""How soon pages of a site are seen in headless Chromium, opened from their folder, and how much they load."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Final
from urllib.parse import unquote, urlsplit

if TYPE_CHECKING:
    from playwright.sync_api import Browser

OPENED: Final = 5
WINDOW: Final = {"width": 1280, "height": 900}
_TIMES: Final = """() => new Promise((told) => {
  const wait = () => {
    const paint = performance.getEntriesByName("first-contentful-paint")[0];
    const page = performance.getEntriesByType("navigation")[0];
    if (paint && page.loadEventEnd) told([paint.startTime, page.loadEventEnd]);
    else requestAnimationFrame(wait);
  };
  wait();
})"""


@dataclass(frozen=True)
class PageSeen:
    """A page as it was opened."""

    first_paint_s: float
    """From asking for it to its first content, the median of several openings, each in a browser profile of its own."""
    load_s: float
    """The same, to its load event: all that it loads before anything is scrolled or pressed is there."""
    loaded_bytes: int
    """Of the page and all files that it loaded by then."""
    files: int


def seen(pages: Mapping[str, Path]) -> dict[str, PageSeen]:
    """Open each page, by its name."""
    with _chromium() as browser:
        return {name: _opened(browser, page) for name, page in pages.items()}


@contextmanager
def _chromium() -> Iterator[Browser]:
    from playwright.sync_api import sync_playwright

    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if chromium is None:
        raise SystemExit("there is no Chromium on this machine: install it to measure how soon a page is seen")
    arguments = ["--no-sandbox", "--disable-gpu", "--disable-background-networking"]
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=arguments)
        yield browser
        browser.close()


def _opened(browser: Browser, page: Path) -> PageSeen:
    paints, loads, files = [], [], set[str]()
    for _ in range(OPENED):
        context = browser.new_context(viewport={"width": WINDOW["width"], "height": WINDOW["height"]})
        shown = context.new_page()
        shown.on("request", lambda request: files.add(request.url))
        shown.goto(page.as_uri())
        paint, load = shown.evaluate(_TIMES)
        paints.append(paint / 1000)
        loads.append(load / 1000)
        context.close()
    paths = {Path(unquote(urlsplit(url).path)) for url in files if url.startswith("file:")}
    return PageSeen(median(paints), median(loads), sum(path.stat().st_size for path in paths), len(paths))
