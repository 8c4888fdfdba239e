"""What a reader does on pages: sorts, finds, chooses, compares, follows a link to a place; and how pages look."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.reports.watching import watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


def page_of(home: Path, kind: str) -> Path:
    """The first page of a kind."""
    return min((home / "site").glob(kind))


def names(page: Page) -> list[str]:
    """Configurations of the leaderboard that are seen, from top to bottom."""
    return page.locator("table.standings tbody tr:visible th").all_inner_texts()


def test_a_press_on_a_head_sorts_and_a_second_one_turns(browser: Browser, made_home: Path) -> None:
    with watched(browser, page_of(made_home, "index.html")) as page:
        ranked = ["agent-01", "agent-02", "agent-03", "agent-04"]
        assert names(page) == [*ranked, "agent-05"], "the incomplete one stands below, without a score"
        head = page.get_by_role("button", name="Overall").first
        head.click()
        assert names(page) == [*ranked, "agent-05"]
        head.press("Enter")
        assert names(page) == [*ranked[::-1], "agent-05"], "what has no score stays below"
        assert page.locator("table.standings th[aria-sort]").get_attribute("aria-sort") == "ascending"
        page.get_by_role("searchbox").fill("agent-03")
        assert names(page) == ["agent-03"]


def test_two_are_chosen_shown_alone_and_compared(browser: Browser, made_home: Path) -> None:
    with watched(browser, page_of(made_home, "index.html")) as page:
        for name in ("agent-02", "agent-04"):
            page.get_by_role("checkbox", name=f"choose {name}").press("Space")
        page.get_by_role("button", name="Only the chosen").click()
        assert names(page) == ["agent-02", "agent-04"] and "chosen=agent-02" in page.url
        page.get_by_role("link", name="Compare the chosen").click()
        assert (
            page.locator("#first").input_value() == "agent-02" and page.locator("#second").input_value() == "agent-04"
        )
        told = page.locator("#pair table").first.locator("tbody tr").last
        assert "+" in told.inner_text()
        assert page.locator(".cross a").count() == page.locator(".pair-cases tbody tr").count() > 20
        page.get_by_role("button", name="exchange the two").click()
        assert "a=agent-04" in page.url and "−" in told.inner_text()


def test_an_address_leads_to_a_comparison(browser: Browser, made_home: Path) -> None:
    with watched(browser, page_of(made_home, "boards/*compare*"), fragment="#a=agent-03&b=agent-05") as page:
        assert page.locator("#second").input_value() == "agent-05"
        assert "lacks outcomes" in page.locator("#pair").inner_text()


def test_cases_are_found_by_setting_and_word(browser: Browser, made_home: Path) -> None:
    with watched(browser, page_of(made_home, "boards/*--cases--*")) as page:
        rows = page.locator("#matrix tbody tr:visible")
        everything = rows.count()
        page.get_by_label("Setting").select_option(label="Text to scene")
        assert 0 < rows.count() < everything
        page.get_by_role("searchbox").fill("text-to-scene-03")
        assert rows.count() == 1
        rows.get_by_role("rowheader").get_by_role("link").click()
        assert "text-to-scene-03" in page.locator("h1").inner_text()


def test_pages_tell_it_without_scripts(browser: Browser, made_home: Path) -> None:
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(page_of(made_home, "boards/*compare*").as_uri())
    assert page.locator("#pairs tbody tr").count() == 6 and page.locator(".tools:visible").count() == 0
    page.goto(page_of(made_home, "index.html").as_uri())
    assert len(names(page)) == 5 and page.get_by_text("main-results").count()
    context.close()


def test_an_address_restores_what_was_set_up(browser: Browser, made_home: Path) -> None:
    """Sorted, searched, chosen: all of it is in the address, and one reader's address is another's view."""
    with watched(browser, page_of(made_home, "index.html")) as page:
        page.get_by_role("button", name="Detailed").first.press("Enter")
        page.get_by_role("button", name="Detailed").first.press("Enter")
        page.get_by_role("checkbox", name="choose agent-02").press("Space")
        page.get_by_role("searchbox").first.fill("agent-0")
        wanted, address = names(page), page.url
        assert {"sort=", "find=", "chosen="} <= {
            f"{part.partition('=')[0]}=" for part in address.split("#")[1].split("&")
        }
    with watched(browser, page_of(made_home, "index.html"), fragment="#" + address.partition("#")[2]) as page:
        assert names(page) == wanted != ["agent-01", "agent-02", "agent-03", "agent-04", "agent-05"]
        assert page.locator("table.standings th[aria-sort=ascending]").inner_text().startswith("Detailed")
        assert page.get_by_role("checkbox", name="choose agent-02").is_checked()
        page.evaluate("location.hash = '#chosen=agent-04'")
        page.wait_for_function("document.querySelector('input.choose[value=agent-04]').checked")
        assert not page.get_by_role("checkbox", name="choose agent-02").is_checked()


def test_an_address_restores_found_cards(browser: Browser, made_home: Path) -> None:
    with watched(browser, page_of(made_home, "agents/*agent-02*")) as page:
        page.get_by_label("Find").fill("indoor")
        page.get_by_label("Order").select_option("best first")
        wanted, address = page.locator(".card:visible strong").all_inner_texts(), page.url
    with watched(browser, page_of(made_home, "agents/*agent-02*"), fragment="#" + address.partition("#")[2]) as page:
        assert page.locator(".card:visible strong").all_inner_texts() == wanted
        scores = page.locator(".card:visible").evaluate_all("all => all.map((one) => Number(one.dataset.v))")
        assert scores == sorted(scores, reverse=True) and len(scores) > 5


@pytest.mark.parametrize(
    "odd", ["#sort=nosuch~Overall~up", "#find=standings", "#a=nobody&b=&chosen=%E2%82", "#=&&", "#100%"]
)
def test_an_odd_address_breaks_nothing(browser: Browser, made_home: Path, odd: str) -> None:
    for kind in ("index.html", "boards/*--compare--*", "agents/*agent-02*", "trials/*"):
        with watched(browser, page_of(made_home, kind), fragment=odd) as page:
            assert page.locator("main h1").is_visible()
