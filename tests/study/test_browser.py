"""Annotators in a real browser, with keys alone: a whole design, a kill in its middle, and what comes of it."""

from __future__ import annotations

import io
import json
from collections import Counter
from itertools import combinations, pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from PIL import Image, PngImagePlugin

from c4s.human import OpenStudy, agreement, design_study, study_named, take
from c4s.protocol.criteria import CRITERIA, PRIMARY, SPLIT_SEED
from c4s.records.human import PICTURES, HumanRanking
from tests.study.conftest import PEOPLE, PROMPTS, SEVEN, Serve, seat

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page, Route

SECOND = "physical-plausibility"
CHUNKS = {b"IHDR", b"PLTE", b"tRNS", b"IDAT", b"IEND"}


def brightness(data: bytes) -> float:
    return float(sum(Image.open(io.BytesIO(data)).convert("RGB").getpixel((0, 0))))  # type: ignore[arg-type]


BRIGHTNESS = """() => Object.fromEntries(Array.from(document.querySelectorAll(".scene"), (scene) => {
  const canvas = new OffscreenCanvas(1, 1);
  const paper = canvas.getContext("2d");
  paper.drawImage(scene.querySelector(".picture.now img"), 0, 0, 1, 1, 0, 0, 1, 1);
  const [red, green, blue] = paper.getImageData(0, 0, 1, 1).data;
  return [scene.dataset.letter, red + green + blue];
}))"""


def light_of(page: Page) -> dict[str, float]:
    """How bright the scene of each letter is, as the page shows it."""
    page.wait_for_function("Array.from(document.images).every((one) => one.complete || !one.src)")
    found: dict[str, float] = page.evaluate(BRIGHTNESS)
    return found


def seen(page: Page) -> list[str]:
    """The letters of the scenes, the brightest first, as the pictures on the page have it."""
    light = light_of(page)
    return sorted("ABC", key=lambda letter: -light[letter])


def rank_by_keys(page: Page) -> None:
    """One question, without a pointer."""
    number = page.url.rpartition("/")[2]
    for letter in seen(page):
        page.keyboard.press(letter.lower())
    page.keyboard.press("Enter")
    page.wait_for_url(lambda url: not url.endswith(f"/{number}"))


@pytest.fixture
def small(home: Path) -> OpenStudy:
    """A study of two criteria."""
    design_study(
        home / "runs" / "night",
        home / "suites",
        home / "human" / "small",
        agents=SEVEN,
        cases=[],
        annotators=PEOPLE,
        criteria=[SECOND],
        seed=SPLIT_SEED,
    )
    return study_named(home / "human", "small")


def test_seven_criteria_one_after_the_other(study: OpenStudy, serve: Serve, browser: Browser) -> None:
    """All that one person is asked, the browser closed after each criterion."""
    link = serve("serve", "yards").links[PEOPLE[0]]
    asked = []
    for number in range(1, 3 * PROMPTS * len(CRITERIA) + 1, 3 * PROMPTS):
        with seat(browser) as page:
            page.goto(link)
            page.get_by_role("link", name="Begin" if number == 1 else "Go on").press("Enter")
            for question in range(number, number + 3 * PROMPTS):
                page.wait_for_url(f"**/{question}")
                asked.append(page.inner_text("h1"))
                rank_by_keys(page)
    titles = [one.title for one in CRITERIA.values()]
    assert asked == [title for title in titles for _ in range(3 * PROMPTS)]
    rows = [json.loads(line) for line in study.folder.answers.read_text().splitlines()]
    assert [CRITERIA[row["criterion"]].title for row in rows] == asked


def test_a_whole_block_design_by_keys(small: OpenStudy, serve: Serve, browser: Browser) -> None:
    """Seven people; one closes the browser in the middle, for another the server is killed."""
    study, criteria = small, (PRIMARY, SECOND)
    served = serve("serve", "small")
    asked, kept = 3 * PROMPTS * len(criteria), b""
    places: Counter[tuple[str, float, str]] = Counter()
    for at, person in enumerate(PEOPLE):
        number = 1
        while number <= asked:
            with seat(browser) as page:
                page.goto(served.links[person])
                page.get_by_role("link", name="Begin" if number == 1 else "Go on").press("Enter")
                page.wait_for_url(f"**/{number}")
                ends = asked // 3 if at == 1 and number == 1 else asked
                while number <= ends:
                    title, light = page.inner_text("h1"), light_of(page)
                    places.update((title, value, letter) for letter, value in light.items())
                    if (at, number) == (3, asked // 2):
                        served.kill()
                        for letter in seen(page):
                            page.keyboard.press(letter)
                        page.keyboard.press("Enter")
                        page.get_by_text("Not kept yet").wait_for()
                        assert len(study.folder.answers.read_text().splitlines()) == at * asked + number - 1
                        served = serve("serve", "small")
                        page.wait_for_url(f"**/{number + 1}")
                    else:
                        rank_by_keys(page)
                    number += 1
                if number > asked:
                    assert "Everything is answered" in page.inner_text("main")
        now = study.folder.answers.read_bytes()
        assert now.startswith(kept) and now.count(b"\n") == (at + 1) * asked, "answers are only appended"
        kept = now
    assert len(places) == PROMPTS * len(criteria) * len(SEVEN) * 3
    assert set(places.values()) == {3}, "each scene stands as often left as right, for each criterion"
    rankings = [HumanRanking.parse(json.loads(line)) for line in kept.splitlines()]
    light = {
        one.candidate: brightness(study.folder.picture(one.candidate, 1).read_bytes())
        for prompt in study.study.prompts
        for one in prompt.candidates
    }
    assert all(light[a] > light[b] for row in rankings for a, b in pairwise(row.order)), "what was seen is kept"
    pairs = Counter((row.criterion, *sorted(two)) for row in rankings for two in combinations(row.order, 2))
    assert len(pairs) == PROMPTS * len(criteria) * 21 and set(pairs.values()) == {3}, "every two meet as often"
    with seat(browser) as page:
        page.goto(served.links["organiser"])
        assert {row.inner_text() for row in page.locator("#progress td.r").all()} == {f"{3 * PROMPTS} / {3 * PROMPTS}"}
    found = take(study, study.folder.answers)
    assert found.faults == [] and set(found.missing.values()) == {0} and found.taken == asked * len(PEOPLE)
    assert agreement(study, PRIMARY).tables[0].rows


def test_nothing_that_a_browser_gets_tells_whose_a_scene_is(
    home: Path, study: OpenStudy, serve: Serve, page: Page
) -> None:
    told = PngImagePlugin.PngInfo()
    told.add_text("Title", SEVEN[0])
    for one in study.folder.root.glob("pictures/*/*.png"):
        Image.open(one).save(one, pnginfo=told, exif=b"MM\x00*\x00\x00\x00\x08\x00\x00agent-a", dpi=(72, 72))
    assert SEVEN[0].encode() in next(study.folder.root.glob("pictures/*/*.png")).read_bytes()
    got: list[tuple[str, str, bytes]] = []

    def note(route: Route) -> None:
        answer = route.fetch(max_redirects=0)
        got.append((route.request.url, str(answer.headers), answer.body()))
        route.fulfill(response=answer)

    served = serve("serve", "yards")
    page.route("**", note)
    page.goto(served.links[PEOPLE[0]])
    page.goto(served.links[PEOPLE[0]] + "next")
    for _ in range(4):
        for view in "1234":
            page.keyboard.press(view)
        page.wait_for_load_state("networkidle")
        rank_by_keys(page)
    page.wait_for_load_state("networkidle")
    page.unroute_all(behavior="wait")
    pictures = [body for url, _, body in got if url.endswith(".png")]
    assert len(pictures) >= 4 * 3 * PICTURES
    assert all(set(chunk_names(body)) <= CHUNKS for body in pictures)
    design = study.study
    secret = {*SEVEN, design.run_id, design.suite_id, design.policy, design.engine, str(design.seed), *PEOPLE}
    secret |= {prompt.case_id for prompt in design.prompts} | {task.task for task in design.tasks}
    for prompt in design.prompts:
        secret |= {word for one in prompt.candidates for word in (one.candidate, one.trial, one.score_sha256)}
    for part in ("development", "holdout"):
        for one in study.saved(part).candidates:  # type: ignore[arg-type]
            secret |= {repr(one.score), f"{one.score:.4f}", *map(repr, one.families.values())}
    for url, headers, body in got:
        text = body.decode("latin-1")
        assert [word for word in secret if word in url or word in headers or word in text] == [], url


def chunk_names(data: bytes) -> list[bytes]:
    found, at = [], 8
    while at < len(data):
        found.append(data[at + 4 : at + 8])
        at += 12 + int.from_bytes(data[at : at + 4], "big")
    return found


def test_pictures_are_switched_and_enlarged_by_keys(serve: Serve, page: Page) -> None:
    page.goto(serve("serve", "yards").links[PEOPLE[0]] + "1")

    def sides() -> list[str | None]:
        return [one.get_attribute("data-view") for one in page.locator(".picture.now").all()]

    assert sides() == ["1"] * 3
    page.keyboard.press("3")
    assert sides() == ["3"] * 3
    page.get_by_role("button", name="Scene B, side 4").focus()
    page.keyboard.press("Space")
    assert sides() == ["3", "4", "3"]
    page.keyboard.press("z")
    assert page.locator("#zoom[open] span").inner_text() == "Scene B, side 4"
    for key, shown in (("a", "Scene A, side 4"), ("2", "Scene A, side 2"), ("ArrowRight", "Scene B, side 2")):
        page.keyboard.press(key)
        assert page.locator("#zoom span").inner_text() == shown
    assert page.locator("#zoom img").evaluate("e => e.offsetWidth") > 1200
    assert page.locator("input:checked").count() == 0, "letters choose a picture while one is enlarged"
    page.keyboard.press("Escape")
    assert page.locator("#zoom[open]").count() == 0
    page.get_by_role("button", name="Scene B, side 1").click()
    page.keyboard.press("b")
    page.keyboard.press("Enter")
    assert "Give each scene a place" in page.inner_text("#order")
    page.keyboard.press("a")
    assert page.inner_text("#order") == "best B, middle A, worst C"
    page.keyboard.press("Backspace")
    assert page.inner_text("#order") == "best B, middle –, worst –"


def test_it_works_without_scripts(home: Path, serve: Serve, browser: object, study: OpenStudy) -> None:
    link = serve("serve", "yards").links[PEOPLE[1]]
    page = browser.new_page(java_script_enabled=False)  # type: ignore[attr-defined]
    page.goto(link)
    page.get_by_role("link", name="Begin").click()
    assert page.locator(".picture:visible").count() == 12
    page.get_by_role("button", name="Keep").click()
    assert "no ties" in page.inner_text(".wrong")
    for rank, letter in (("best", "C"), ("middle", "A"), ("worst", "B")):
        page.locator(f'input[name="{rank}"][value="{letter}"]').check()
    page.get_by_role("button", name="Keep").click()
    assert page.url.endswith("/2")
    assert len(study.folder.answers.read_text().splitlines()) == 1
    page.close()


def test_reviewers_see_what_an_agent_sees(home: Path, serve: Serve, page: Page) -> None:
    served = serve("review", "places", "--reviewer", "ann", "--reviewer", "bob")
    page.goto(served.links["ann"])
    page.get_by_role("link", name="Begin").press("Enter")
    names = [f"place-{number:02}" for number in range(PROMPTS)]
    for number in range(1, PROMPTS + 1):
        page.wait_for_url(f"**/{number}")
        shown = page.content()
        assert "a yard" in shown and not any(name in shown for name in names)
        for question in ("clear", "solvable", "consistent"):
            page.locator(f'input[name="{question}"][value="{"no" if number == 2 else "yes"}"]').focus()
            page.keyboard.press("Space")
        if number == 2:
            page.locator("#keep").press("Enter")
            page.get_by_text("say in the note").wait_for()
            page.locator("#note").fill("<script>alert(1)</script> no box is listed")
        page.locator("#keep").press("Enter")
    page.get_by_text("Everything is answered").wait_for()
    served.kill()
    served = serve("review", "places", "--reviewer", "ann", "--reviewer", "bob")
    page.goto(served.links["organiser"])
    assert [one.inner_text() for one in page.locator("#progress td.r").all()] == ["2 / 2", "0 / 2"]
    assert "<script>alert(1)</script> no box is listed" in page.inner_text("main")
    rows = (home / "human" / "reviews" / "places" / "reviews.jsonl").read_text().splitlines()
    assert [json.loads(row)["reviewer"] for row in rows] == ["ann"] * PROMPTS
