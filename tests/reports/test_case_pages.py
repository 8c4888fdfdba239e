"""The pages of cases and trials in a browser: compared, worked out, told call by call, and safe from what they show."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from c4s.score.policies import POLICIES
from reports.case.code import code_tokens
from tests.reports.hostile import MARKUP, SCRIPT
from tests.reports.played import AGENTS
from tests.reports.watching import watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser


@pytest.fixture
def home(hostile_home: Path) -> Path:
    """Played trials whose texts are hostile."""
    return hostile_home


def page_of(home: Path, pattern: str) -> Path:
    (found,) = (home / "site").glob(pattern)
    return found


def test_two_renders_are_compared_by_keyboard(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "cases/*bath*")) as page:
        ways = page.locator(".compare select")
        assert ways.nth(0).input_value() == "Truth" and ways.nth(1).input_value() == "planner"
        ways.nth(0).select_option("Start")
        before, slider = page.locator(".stage img").nth(1).get_attribute("src"), page.locator(".compare input")
        slider.focus()
        for _ in range(5):
            page.keyboard.press("ArrowRight")
        assert slider.input_value() == "55"
        assert page.locator(".stage").evaluate("stage => stage.style.getPropertyValue('--cut')") == "55%"
        ways.nth(2).select_option(index=1)
        assert page.locator(".stage img").nth(1).get_attribute("src") != before
        assert page.locator(".compare p").inner_text() == "Start | planner"
        camera, address = ways.nth(2).input_value(), page.url
    with watched(browser, page_of(home, "cases/*bath*"), fragment="#" + address.partition("#")[2]) as page:
        assert page.locator(".compare p").inner_text() == "Start | planner"
        assert page.locator(".compare input").input_value() == "55"
        assert page.locator(".compare select").nth(2).input_value() == camera


def test_one_brightness_holds_for_all_rows(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "cases/*bath*")) as page:
        page.check(".b150")
        found = page.eval_on_selector_all(".renders img", "all => all.map(one => getComputedStyle(one).filter)")
        assert len(found) > 6 and set(found) == {"brightness(1.5)"}


def test_configurations_stand_in_one_order(home: Path) -> None:
    board = (home / "site/index.html").read_text()
    order = sorted(AGENTS, key=lambda name: board.index(f">{name}</a>"))
    for path in (home / "site/cases").glob("*.html"):
        runs = re.findall(r'<tr id="([a-z]+)"', path.read_text())
        assert runs == order


def test_whole_texts_come_when_a_call_is_opened(browser: Browser, home: Path) -> None:
    path = page_of(home, "trials/*text-flat*planner*")
    asked: list[str] = []
    with watched(browser, path) as page:
        page.on("request", lambda request: asked.append(request.url))
        call = page.locator("#a1-c1")
        assert (call.locator("pre").first.text_content() or "").endswith("…")
        call.locator("summary").click()
        page.wait_for_selector("#a1-c1 .code-k")
        assert call.locator("[data-part=script]").text_content() == SCRIPT
        assert "10,000,000 characters" in call.inner_text()
        answer = call.locator("[data-part=answer]").text_content() or ""
        assert MARKUP in answer and "\\u202eevil" in answer and "\\x00" in answer and "\u202e" not in answer
        page.locator("#a1-c2 summary").click()
    assert len([url for url in asked if "/data/calls-" in url]) == 1


def test_a_call_and_a_requirement_can_be_linked(browser: Browser, home: Path) -> None:
    path = page_of(home, "trials/*text-flat*planner*")
    with watched(browser, path, fragment="#a1-c2") as page:
        assert page.locator("#a1-c2").get_attribute("open") is not None
    claim = re.findall(r'id="(claim-[^"]+)"', path.read_text())[0]
    with watched(browser, path, fragment=f"#{claim}") as page:
        assert page.locator(f"#{claim}").is_visible()


def test_requirements_are_filtered_by_answer(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "trials/*text-flat*planner*")) as page:
        shown = page.locator(".answers tbody tr:visible")
        every = shown.count()
        page.check(".f-mismatch")
        assert 0 < shown.count() < every
        assert shown.locator("td:first-child").all_inner_texts() == ["MISMATCH"] * shown.count()


def test_a_page_is_whole_without_a_script(browser: Browser, home: Path) -> None:
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(page_of(home, "trials/*bath*planner*").as_uri())
    told = page.inner_text("main")
    for words in (
        "How the score comes about",
        "Evaluation trace",
        "Repair targets",
        "What the agent did",
        "save_scene_as",
    ):
        assert words in told
    assert page.locator(".grid img").count() > 3 and page.locator(".stage").count() == 0
    context.close()


def test_a_zero_and_both_of_its_attempts_are_told(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "trials/*text-flat*vandal*")) as page:
        told = page.inner_text("main")
        assert "Nothing was measured" in told and page.locator("article.attempt").count() == 2
        assert page.locator(".attempt .tag.bad").first.inner_text() in ("invalid submission", "nothing saved")


def test_the_score_is_shown_with_its_parts(home: Path) -> None:
    for name in ("planner", "oracle"):
        text = page_of(home, f"trials/*bath*{name}*").read_text()
        assert "computed anew from their parts and are the stored ones" in text and "stored:" not in text


def test_a_higher_and_a_lower_run_stand_below_each_other(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "cases/*bath*")) as page:
        titles = page.locator(".paired p strong").all_inner_texts()
        assert titles[0] == "Ground truth" and titles[1].startswith("Higher") and titles[2].startswith("Lower")


def test_the_pair_is_worked_out_and_told_apart(browser: Browser, home: Path) -> None:
    """Two runs of a text: one is built by plan, the other, with the truth, is not ranked; both flows sum up."""
    with watched(browser, page_of(home, "cases/*text-flat*")) as page:
        boxes = page.locator("#pair .paired")
        if boxes.count() == 0:
            assert page.locator("#pair").count() == 0
        for box in boxes.all():
            nodes = [text.split("\n") for text in box.locator(".flow .node").all_inner_texts()]
            shares = [float(node[2].split("= ")[1]) for node in nodes[:-1]]
            assert sum(shares) == pytest.approx(float(nodes[-1][1]), abs=2e-4)
            assert "eligible" in box.locator(".told").inner_text()
        for row in page.locator("table.apart tbody tr").all():
            high, low = row.locator("td .outcome").all_inner_texts()
            assert high != low


def test_a_trace_shows_evidence_and_leads_to_each_number(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "trials/*text-flat*planner*")) as page:
        steps = page.locator("ol.trace > li")
        links = steps.locator("strong a").evaluate_all("all => all.map(one => one.getAttribute('href'))")
        assert "#attempt-1" in links and "#score-detailed" in links and "#score-case" in links
        assert all(page.locator(link).count() == 1 for link in links)
        assert steps.locator("img").count() > 4
        assert "c4s sql" in page.locator("#trace").inner_text()


def test_scores_lead_to_their_runs(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "boards/*--cases--*")) as page:
        row = page.locator("#matrix tbody tr", has_text="text-flat-family")
        row.locator('td[data-configuration="planner"] a').click()
        assert page.inner_text("h1").startswith("planner on text-flat-family")
    with watched(browser, page_of(home, "agents/*planner*")) as page:
        page.locator("a.card", has_text="text-flat-family").click()
        assert page.inner_text("h1").startswith("planner on text-flat-family")


def test_other_policies_are_told_as_they_would_score(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, "boards/*--compare--*"), fragment="#policies") as page:
        heads = page.locator("#under-policies thead th").all_inner_texts()
        assert [head.split()[0] for head in heads[1:]] == list(POLICIES)
        oracle = page.locator('#under-policies tr[data-configuration="oracle"] td .n').all_inner_texts()
        vandal = page.locator('#under-policies tr[data-configuration="vandal"] td .n').all_inner_texts()
        assert vandal == ["0.000"] * len(POLICIES) and min(map(float, oracle)) > 0.5
        assert page.locator("dl.policies > div").count() == len(POLICIES) - 1


def test_tokens_are_the_whole_text() -> None:
    for text in (SCRIPT, "", "x", "  \n", "def f(:\n\t'''", "\u202e\0 é", MARKUP):
        assert "".join(part for _, part in code_tokens(text)) == text
