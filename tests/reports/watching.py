"""Looking at a page as a reader does, and seeing what a reader would not: faults, requests, what axe finds."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


@contextmanager
def watched(
    browser: Browser, page: Path, *, scheme: Literal["light", "dark"] = "light", width: int = 1280, fragment: str = ""
) -> Iterator[Page]:
    """A page of a site, open; at the end nothing may have gone wrong on it, and nothing left the site's folder.

    What is asked for is told by the browser's own network events, whatever asks for it.

    Args:
        browser: the fixture.
        page: a file of the site.
        scheme: which colours the reader prefers.
        width: of the window, pixels.
        fragment: of the address, with its ``#``.
    """
    markers = (".c4s-site", ".c4s-manual")
    site = next((folder for folder in page.parents if any((folder / one).is_file() for one in markers)), page.parent)
    context = browser.new_context(
        viewport={"width": width, "height": 900}, color_scheme=scheme, reduced_motion="reduce"
    )
    shown = context.new_page()
    faults: list[str] = []

    def asked(url: str) -> None:
        if leaves(url, site):
            faults.append(url)

    shown.on("pageerror", lambda error: faults.append(str(error)))
    shown.on("console", lambda told: faults.append(told.text) if told.type in ("error", "warning") else None)
    shown.on("requestfailed", lambda request: faults.append(request.url))
    shown.on("dialog", lambda dialog: faults.append(f"dialog: {dialog.message}"))
    network = context.new_cdp_session(shown)
    network.send("Network.enable")
    network.on("Network.requestWillBeSent", lambda told: asked(told["request"]["url"]))
    network.on("Network.webSocketCreated", lambda told: asked(told["url"]))
    shown.goto(page.as_uri() + fragment)
    try:
        yield shown
    finally:
        context.close()
    assert not faults, faults


def leaves(address: str, site: Path) -> bool:
    """Whether an address is neither in the site's folder nor in the page itself."""
    return not address.startswith((site.resolve().as_uri() + "/", site.as_uri() + "/", "data:", "blob:"))


def complaints(page: Page) -> list[str]:
    """What axe-core finds wrong with an open page by WCAG 2.2 A and AA, each with where."""
    page.evaluate(_axe())
    found: dict[str, Any] = page.evaluate(
        "() => axe.run(document, {preload: false, runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa']})"
    )
    return [
        f"{one['id']}: {node['target']} {node['failureSummary']}"
        for one in found["violations"]
        for node in one["nodes"]
    ]


@cache
def _axe() -> str:
    found = importlib.util.find_spec("axe_playwright_python")
    assert found and found.submodule_search_locations
    return (Path(found.submodule_search_locations[0]) / "axe.min.js").read_text(encoding="utf-8")
