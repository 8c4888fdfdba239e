"""Every kind of page in a browser: everybody can read it, in light and dark, narrow, by keys alone, as it was."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import pytest

from tests.reports.kinds import KINDS
from tests.reports.pictures import KEEP, assert_as_kept
from tests.reports.watching import complaints, watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

CHANGES = {
    "a table is gone": "document.querySelector('table').hidden = true",
    "a title is gone": "document.querySelector('h1').hidden = true",
    "text has another colour": "document.documentElement.style.setProperty('--ink', '#d00')",
    "shades are gone": "document.querySelectorAll('td').forEach((one) => { one.style.background = 'none'; })",
    "the page is narrow": "document.querySelector('main').style.maxWidth = '900px'",
}
Scheme = Literal["light", "dark"]
MOST_STOPS = 250
"""Places of a page that the key Tab is pressed for."""
REACHABLE = """() => {
  const radios = new Set();
  const found = document.querySelectorAll("a[href], button, input, select, textarea, summary, [tabindex='0']");
  return Array.from(found).filter((one) => {
    if (one.disabled || !one.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true })) return false;
    if (one.type !== "radio") return true;
    const known = radios.has(one.name);
    radios.add(one.name);
    return !known;
  }).length;
}"""
FOCUSED = """() => {
  const one = document.activeElement;
  if (one === document.body) return null;
  const style = getComputedStyle(one);
  const box = one.getBoundingClientRect();
  return { place: Array.from(document.querySelectorAll("*")).indexOf(one), name: one.outerHTML.slice(0, 120),
    ring: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0,
    inside: box.bottom > 0 && box.top < innerHeight };
}"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("kind", KINDS)
def test_anybody_can_read_it(browser: Browser, page_of: Callable[[str], Path], kind: str, scheme: Scheme) -> None:
    with watched(browser, page_of(kind), scheme=scheme) as page:
        page.eval_on_selector_all("details", "all => all.forEach((one) => { one.open = true; })")
        assert complaints(page) == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("kind", KINDS)
def test_it_looks_as_it_did(browser: Browser, page_of: Callable[[str], Path], kind: str, scheme: Scheme) -> None:
    with watched(browser, page_of(kind), scheme=scheme) as page:
        assert_as_kept(page, f"{kind}-{scheme}")


@pytest.mark.parametrize("change", CHANGES)
def test_a_page_that_changed_is_seen(
    browser: Browser, page_of: Callable[[str], Path], change: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv(KEEP, raising=False)
    with watched(browser, page_of("cases")) as page:
        page.evaluate(CHANGES[change])
        with pytest.raises(AssertionError, match="of it is other"):
            assert_as_kept(page, "cases-light")


def test_other_letters_are_not_another_page(
    browser: Browser, page_of: Callable[[str], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv(KEEP, raising=False)
    with watched(browser, page_of("leaderboard")) as page:
        page.evaluate("document.body.style.fontFamily = 'Liberation Serif, Georgia, serif'")
        assert_as_kept(page, "leaderboard-light")


@pytest.mark.parametrize("kind", KINDS)
def test_a_narrow_window_scrolls_down_alone(browser: Browser, page_of: Callable[[str], Path], kind: str) -> None:
    path = page_of(kind)
    assert path.stat().st_size < (500_000 if kind == "leaderboard" else 3_000_000)
    with watched(browser, path, width=390) as page:
        assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")


@pytest.mark.parametrize("kind", KINDS)
def test_keys_reach_everything_and_show_where_they_are(
    browser: Browser, page_of: Callable[[str], Path], kind: str
) -> None:
    with watched(browser, page_of(kind)) as page:
        wanted = page.evaluate(REACHABLE)
        stops = tabbed(page, min(wanted, MOST_STOPS))
        assert len({stop["place"] for stop in stops}) == min(wanted, MOST_STOPS), "a place is not reached"
        assert [stop["name"] for stop in stops if not stop["ring"] or not stop["inside"]] == []


def tabbed(page: Page, count: int) -> list[dict[str, Any]]:
    """Where so many presses of Tab lead."""
    stops = []
    for _ in range(count):
        page.keyboard.press("Tab")
        stops.append(page.evaluate(FOCUSED))
    assert None not in stops, "the keys lead out of the page before its end"
    return stops
