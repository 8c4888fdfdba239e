"""Texts from outside stay texts, on every page; and a page that markup got into would still run none of it."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.reports.hostile import MARKUP
from tests.reports.played import REPAIR, page_of
from tests.reports.watching import watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser

INJECTED = """() => [
  ...document.querySelectorAll("script:not([src]), iframe, object, embed, base, form, img[src='x'], main svg[onload]"),
  ...Array.from(document.querySelectorAll("*")).filter((one) => Array.from(one.attributes).some((each) =>
    each.name.startsWith("on") || (["href", "src"].includes(each.name) && each.value.startsWith("javascript:")))),
].map((one) => one.outerHTML.slice(0, 200))"""
OUTSIDE = "https://example.invalid/spy.js"
ATTACK = f"""<script>window.ran = "inline"</script><img src="x" onerror="window.ran = 'event'">
<script src="{OUTSIDE}"></script><img src="https://example.invalid/spy.png"><iframe src="https://example.invalid/"></iframe>
<link rel="stylesheet" href="https://example.invalid/spy.css"><form action="https://example.invalid/"><button id="send">
</button></form><p id="styled" style="position: fixed">text</p>"""


def pages(home: Path) -> Iterator[Path]:
    yield from sorted((home / "site").rglob("*.html"))


def test_no_file_holds_markup_or_hidden_characters_of_a_text(hostile_home: Path) -> None:
    scripts = list((hostile_home / "site/data").glob("*.js"))
    assert len(list(pages(hostile_home))) > 15 and len(scripts) > 2
    for path in (*pages(hostile_home), *scripts):
        text = path.read_text()
        assert "<script>alert" not in text and "<svg onload" not in text and "<img src=x" not in text, path.name
        assert "\u202e" not in text and "\0" not in text and "\x1b" not in text, path.name
    assert not any("<" in path.read_text() for path in scripts)


def test_every_page_shows_them_as_texts(browser: Browser, hostile_home: Path) -> None:
    seen = 0
    for path in pages(hostile_home):
        assert path.stat().st_size < 3_000_000
        with watched(browser, path, width=390) as page:
            assert page.evaluate(INJECTED) == [], path.name
            assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth"), path.name
            page.eval_on_selector_all("details", "all => all.forEach((one) => { one.open = true; })")
            seen += MARKUP in page.inner_text("body")
    assert seen > 8


def test_the_3d_view_shows_them_as_texts(browser: Browser, hostile_home: Path) -> None:
    with watched(browser, page_of(hostile_home, REPAIR)) as page:
        page.get_by_role("button", name="Open the 3D view").click()
        page.wait_for_selector("#scene[data-shown]")
        page.locator(".scene-list").focus()
        page.keyboard.press("Home")
        page.locator(".scene-panel h3").wait_for()
        for place in (".scene-list", ".scene-panel"):
            told = page.locator(place).inner_text()
            assert MARKUP in told and "\u202e" not in told and "\0" not in told, place
        assert page.evaluate(INJECTED) == []


@pytest.mark.parametrize("kind", ["index.html", "cases/*", "trials/*"])
def test_the_policy_runs_nothing_that_got_into_a_page(
    browser: Browser, hostile_home: Path, tmp_path: Path, kind: str
) -> None:
    """A page is spoilt on purpose: whatever it holds, the policy in its head keeps it from being run or fetched."""
    site = tmp_path / "site"
    shutil.copytree(hostile_home / "site", site, ignore=shutil.ignore_patterns("pictures", "scene"))
    path = min(site.glob(kind))
    path.write_text(path.read_text().replace("</main>", f"{ATTACK}</main>"))
    context = browser.new_context()
    page = context.new_page()
    told: list[str] = []
    page.on("console", lambda line: told.append(line.text))
    network = context.new_cdp_session(page)
    network.send("Network.enable")
    answered: list[str] = []
    network.on("Network.responseReceived", lambda event: answered.append(event["response"]["url"]))
    blocked: list[str] = []
    network.on("Network.loadingFailed", lambda event: blocked.append(event.get("blockedReason", "")))
    page.goto(path.as_uri())
    page.locator("#send").dispatch_event("click")
    assert page.evaluate("window.ran") is None
    assert page.evaluate("getComputedStyle(document.getElementById('styled')).position") == "static"
    assert page.url == path.as_uri()
    refused = " ".join(told)
    for directive in ("script-src", "style-src", "img-src", "form-action", "default-src"):
        assert re.search(f"violates the following Content Security Policy directive: .{directive}", refused), directive
    assert blocked.count("csp") >= 3 and not any("example.invalid" in url for url in answered)
    context.close()
