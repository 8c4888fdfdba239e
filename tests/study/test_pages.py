"""Every page that asks people, or tells the organiser: for everybody, light and dark, on paper, and as it was."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import pytest

from tests.built import built_once
from tests.reports.pictures import assert_as_kept
from tests.reports.watching import complaints
from tests.study.conftest import PEOPLE, make_home, seat, serving

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PAGES = ("study-first", "study-ranking", "study-review", "study-review-first", "study-organiser", "study-failed")
NOTE = "<script>alert(1)</script> no box is listed"
Scheme = Literal["light", "dark"]


@pytest.fixture(scope="module")
def links(tmp_path_factory: pytest.TempPathFactory, browser: Browser) -> Iterator[dict[str, str]]:
    """Where each page is, of a study and of a review that has begun."""
    home = Path(
        shutil.copytree(
            built_once(tmp_path_factory, "asking-home", make_home), tmp_path_factory.mktemp("asked") / "home"
        )
    )
    with serving(home) as started:
        study = started("serve", "yards").links[PEOPLE[0]]
        review = started("review", "places", "--reviewer", "ann", "--reviewer", "bob").links
        with seat(browser) as page:
            page.goto(review["bob"] + "1")
            for question in ("clear", "solvable", "consistent"):
                page.locator(f'input[name="{question}"][value="no"]').check()
            page.locator("#note").fill(NOTE)
            page.locator("#keep").press("Enter")
            page.wait_for_url("**/2")
        yield {
            "study-first": study,
            "study-ranking": study + "1",
            "study-review": review["ann"] + "1",
            "study-review-first": review["ann"],
            "study-organiser": review["organiser"],
            "study-failed": study + "99999",
        }


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", PAGES)
def test_anybody_can_read_it(browser: Browser, links: dict[str, str], name: str, scheme: Scheme) -> None:
    with seat(browser, scheme) as page:
        page.goto(links[name])
        assert complaints(page) == []
        if name == "study-ranking":
            page.keyboard.press("z")
            page.locator("#zoom[open]").wait_for()
            assert complaints(page) == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", PAGES)
def test_it_looks_as_it_did(browser: Browser, links: dict[str, str], name: str, scheme: Scheme) -> None:
    with seat(browser, scheme) as page:
        page.goto(links[name])
        settle(page)
        assert_as_kept(page, f"{name}-{scheme}")


def settle(page: Page) -> None:
    """What is drawn anew each time is left out: the keys in links, and which scene stands where."""
    page.evaluate("""() => document.querySelectorAll("code").forEach((one) => { one.textContent = "a link"; })""")
    page.eval_on_selector_all(".picture img", "all => all.forEach((one) => { one.style.opacity = '0'; })")
    page.wait_for_function("Array.from(document.images).every((one) => one.complete || !one.src)")


@pytest.mark.parametrize("name", PAGES)
def test_it_prints(browser: Browser, links: dict[str, str], name: str) -> None:
    with seat(browser, "dark") as page:
        page.goto(links[name])
        page.emulate_media(media="print")
        page.set_viewport_size({"width": 695, "height": 1000})
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
        assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
        assert page.locator("button:visible, .button:visible, input:visible").count() == 0
        if name == "study-ranking":
            assert page.locator(".picture:visible").count() == 12


def test_a_note_is_text(browser: Browser, links: dict[str, str]) -> None:
    with seat(browser) as page:
        page.goto(links["study-organiser"])
        assert NOTE in page.inner_text("main") and page.locator("script:not([src])").count() == 0
