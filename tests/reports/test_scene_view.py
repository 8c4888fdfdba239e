"""The 3D view of a case page, in a browser, opened from a folder."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from c4s.records.captures import Captures
from c4s.records.folder import RunFolder
from c4s.records.suite import SuiteFolder
from tests.reports.played import AGENTS, REPAIR, RUN, TEXT, page_of
from tests.reports.watching import complaints, watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

OPEN = "#scene[data-shown]"
WIDTH, HEIGHT = 480, 270
LEAST_AGREEMENT = 0.97
"""Share of a picture's pixels that show the same actor: edges fall on one pixel here and on its neighbour there."""
LEAST_IOU = 0.9
LEAST_PIXELS = 200


@pytest.fixture
def home(played_home: Path) -> Path:
    return played_home


@contextmanager
def opened(browser: Browser, home: Path, case_id: str) -> Iterator[Page]:
    """The page of a case with its 3D view open."""
    with watched(browser, page_of(home, case_id)) as page:
        page.get_by_role("button", name="Open the 3D view").click()
        page.wait_for_selector(OPEN)
        yield page


def shown(page: Page, mode: str) -> None:
    """Switch to a mode and wait until it is shown."""
    page.get_by_role("radio", name=mode, exact=True).check()
    told = {"Verdicts": "difference"}.get(mode, mode.lower())
    page.wait_for_selector(f"#scene[data-shown^='{told}']")


def colours(page: Page) -> set[tuple[int, int, int]]:
    """The colours of the canvas, coarsely."""
    data: list[int] = page.evaluate(
        """() => { const stage = c4sScene.view.stage; stage.drawNow();
        const gl = stage.renderer.getContext(); const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
        const data = new Uint8Array(4 * w * h); gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, data);
        return Array.from(data.filter((_, at) => at % 4 !== 3 && Math.floor(at / 4) % 7 === 0)); }"""
    )
    return {(r >> 4, g >> 4, b >> 4) for r, g, b in np.array(data, np.uint8).reshape(-1, 3).tolist()}


def ids(page: Page, view: str) -> tuple[np.ndarray[Any, Any], list[str]]:
    """Which actor each pixel of the submission shows from a camera of the evidence (-1 for none), and their names."""
    found = page.evaluate(
        """async ([name, width, height]) => { const view = c4sScene.view;
        view.camera.value = "view " + name; await view.stand(); view.stage.drawNow();
        const names = view.models[0].actors.map((one) => one.name);
        return [view.stage.idsOf(view.stage.panes[0], width, height), names]; }""",
        [view, WIDTH, HEIGHT],
    )
    return np.array(found[0]).reshape(HEIGHT, WIDTH)[::-1] - 1, found[1]


@pytest.mark.parametrize("case_id", [REPAIR, TEXT])
def test_the_view_shows_what_the_engine_photographed(browser: Browser, home: Path, case_id: str) -> None:
    alias = SuiteFolder(home / "suites" / "small").case(case_id).alias
    index = RunFolder(home / "runs" / RUN).trial("planner", alias, 1).evidence.captures_index
    views = [view for view in Captures.read(index).views if view.purpose in ("overview", "reference", "target")]
    with opened(browser, home, case_id) as page:
        page.get_by_label("Submission by").select_option("planner~1")
        shown(page, "Submission")
        for view in views[:3]:
            found, names = ids(page, view.name)
            assert view.actors is not None
            mask = np.load(index.parent / view.actors)
            place = {name: number for number, name in enumerate(names)}
            step = view.camera.width // WIDTH
            numbers = np.array([*(place[name] for name in mask["names"].tolist()), -1])
            wanted = numbers[mask["actor"][step // 2 :: step, step // 2 :: step]][:HEIGHT, :WIDTH]
            assert (wanted == found).mean() > LEAST_AGREEMENT, view.name
            large = [at for at in np.unique(wanted) if at >= 0 and (wanted == at).sum() >= LEAST_PIXELS]
            overlaps = [((wanted == at) & (found == at)).sum() / ((wanted == at) | (found == at)).sum() for at in large]
            assert np.mean(overlaps) > LEAST_IOU, view.name


def test_each_mode_shows_another_picture(browser: Browser, home: Path) -> None:
    with opened(browser, home, REPAIR) as page:
        page.get_by_label("Submission by").select_option("random~1")
        seen = {}
        for mode in ("Start", "Truth", "Submission", "Difference"):
            shown(page, mode)
            seen[mode] = colours(page)
        assert all(len(found) > 10 for found in seen.values())
        assert len(seen["Difference"] - seen["Submission"]) > 5, "what differs is told by colours of its own"
        assert page.locator(".scene-legend li").count() == 6
        page.get_by_label("beside the truth").check()
        page.get_by_label("evidence cameras").check()
        assert page.evaluate("() => c4sScene.view.stage.helpers.children.length") >= 1


def test_a_click_tells_of_the_actor_and_makes_a_link_to_it(browser: Browser, home: Path) -> None:
    with opened(browser, home, REPAIR) as page:
        page.get_by_label("Submission by").select_option("planner~1")
        shown(page, "Submission")
        canvas = page.locator(".scene-stage canvas")
        box = canvas.bounding_box()
        assert box is not None
        canvas.click(position={"x": box["width"] / 2, "y": box["height"] / 2})
        label = page.locator(".scene-panel h3").inner_text()
        assert label and "Location (cm)" in page.locator(".scene-panel dl").inner_text()
        link = page.evaluate("() => location.hash")
        assert link.startswith("#actor=") and link.endswith("of=planner%7E1")
    with watched(browser, page_of(home, REPAIR), fragment=link) as page:
        page.wait_for_selector(OPEN)
        page.wait_for_selector(".scene-panel h3")
        assert page.locator(".scene-panel h3").inner_text() == label
        assert complaints(page) == []


def test_the_keyboard_alone_suffices(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, REPAIR)) as page:
        page.locator(".scene-open button").focus()
        page.keyboard.press("Enter")
        page.wait_for_selector(OPEN)
        page.locator(".scene-list").focus()
        page.keyboard.press("Home")
        first = page.locator(".scene-panel h3").inner_text()
        page.keyboard.press("ArrowDown")
        chosen = page.locator(".scene-list [aria-selected=true] .label").inner_text()
        assert page.locator(".scene-panel h3").inner_text() == chosen
        page.keyboard.press("ArrowUp")
        assert page.locator(".scene-panel h3").inner_text() == first
        page.locator(".scene-stage canvas").focus()
        before = page.evaluate("() => c4sScene.view.stage.camera.position.toArray()")
        for key in ("ArrowLeft", "Shift+ArrowUp", "+"):
            page.keyboard.press(key)
            after = page.evaluate("() => c4sScene.view.stage.camera.position.toArray()")
            assert after != before, key
            before = after


def test_the_tables_tell_what_the_view_shows(browser: Browser, home: Path) -> None:
    with opened(browser, home, REPAIR) as page:
        page.get_by_label("Submission by").select_option("random~1")
        shown(page, "Difference")
        page.wait_for_selector("#scene[data-shown='difference random~1']")
        listed = page.locator(".scene-list li .label").all_inner_texts()
        table = page.locator("details.scene-table", has_text="random")
        table.locator("summary").click()
        told = [row.split("\t")[1] for row in table.locator("tbody tr").all_inner_texts() if "\t" in row]
        assert sorted(told) == sorted(listed)


def test_without_webgl_the_page_says_so(browser: Browser, home: Path) -> None:
    with watched(browser, page_of(home, REPAIR)) as page:
        page.evaluate("() => { HTMLCanvasElement.prototype.getContext = () => null; }")
        page.locator(".scene-open button").click()
        page.get_by_text("This browser draws nothing in three dimensions").wait_for()
        assert page.locator(".scene-view").is_hidden()
        assert page.locator("details.scene-table").count() == len(AGENTS) - 1, "the vandal saves no scene"


def test_where_a_body_can_walk_is_drawn_over_the_scene_and_taken_off_again(browser: Browser, home: Path) -> None:
    with opened(browser, home, TEXT) as page:
        page.get_by_label("Submission by").select_option("planner~1")
        shown(page, "Submission")
        bare = colours(page)
        before = page.evaluate("() => c4sScene.view.stage.idsOf(c4sScene.view.stage.panes[0], 160, 90)")
        page.get_by_label("where a body can walk").check()
        page.get_by_text("largest walkable area", exact=True).first.wait_for()
        counts = page.evaluate("() => c4sScene.view.models[0].overlay.userData.counts")
        assert counts["largest"] >= 1 and counts["reached"] + counts["astray"] > 0
        assert len(colours(page) - bare) > 3, "it has colours of its own"
        after = page.evaluate("() => c4sScene.view.stage.idsOf(c4sScene.view.stage.panes[0], 160, 90)")
        assert before == after, "it is no actor: a click goes through it"
        box = page.evaluate(
            """() => { const made = new THREE.Box3().setFromObject(c4sScene.view.models[0].overlay);
            const all = c4sScene.view.models[0].bounds();
            return [made.min.toArray(), made.max.toArray(), all.min.toArray(), all.max.toArray()]; }"""
        )
        assert all(box[2][axis] - 0.1 <= box[0][axis] and box[1][axis] <= box[3][axis] + 0.1 for axis in (0, 2))
        page.get_by_label("where a body can walk").uncheck()
        page.wait_for_function("() => !c4sScene.view.models[0].overlay")
        assert colours(page) == bare


def test_a_scene_of_which_no_walk_is_known_says_so(browser: Browser, home: Path) -> None:
    """No ``noop`` played, so nothing tells how one walks in the start."""
    with opened(browser, home, REPAIR) as page:
        page.get_by_label("where a body can walk").check()
        shown(page, "Start")
        page.get_by_text("Where a body can walk is not known of this scene.").wait_for()
        shown(page, "Truth")
        page.get_by_text("largest walkable area", exact=True).first.wait_for()
        assert complaints(page) == []
