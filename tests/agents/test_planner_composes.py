"""What the planner composes: as many as the prose says, on and near what it says, and nothing within another."""

from __future__ import annotations

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.agents.baselines.composing import compose
from c4s.agents.baselines.palette import palette
from c4s.records.suite import SuiteFolder
from c4s.semantics.distributions import plan_centres
from c4s.semantics.relations import near, on
from tests.agents.palettes import SIZES, composed, id_of, intruders, prompt_of
from tests.shared import SHARED
from tests.starter import starter_home

PUBLISHED = SHARED / "upstream/benchmark/public/text-to-scene"
NOUNS = ["table", "well", "barn", "cow", "crate", "bench", "pond", "rug"]
RELATIONS = [
    "on",
    "beside",
    "around",
    "behind",
    "in front of",
    "north of",
    "to the west of",
    "between",
    "along",
    "with",
]
COUNTS = {"": 1, "two": 2, "five": 5, "twelve": 12}


@st.composite
def sentences(draw: st.DrawFn) -> str:
    count, noun, relation, other = (draw(st.sampled_from(pool)) for pool in ([*COUNTS], NOUNS, RELATIONS, NOUNS))
    head = f"{count} {noun}s stand" if count else f"A {noun} stands"
    return f"{head} {relation} {draw(st.sampled_from(['a', 'the', 'two']))} {other}."


@settings(max_examples=80, deadline=None)
@given(st.lists(sentences(), min_size=1, max_size=6))
def test_whatever_is_said_nothing_is_within_another(text: list[str]) -> None:
    assert intruders(composed(prompt_of(" ".join(text)))) == []


@settings(max_examples=60, deadline=None)
@given(st.text(max_size=300))
def test_any_prose_composes(text: str) -> None:
    assert compose(prompt_of(text), 60.0)["nodes"]


@pytest.mark.parametrize("word", [word for word in COUNTS if word])
def test_a_number_is_kept(word: str) -> None:
    things = composed(prompt_of(f"{word} cows stand. A barn and a well."))
    assert len(things["cow"]) == COUNTS[word] and len(things["barn"]) == len(things["stone_well"]) == 1


def test_on_and_near_hold_by_the_judges_measures() -> None:
    things = composed(prompt_of("A bowl stands on the table. A cow stands near a well."))
    assert on(things["fruit_bowl"], things["oak_table"]).all()
    assert near(things["cow"], things["stone_well"]).all()
    things = composed(prompt_of("A table stands on a blue rug. Two cows and a bench stand on the road."))
    assert on(things["oak_table"], things["blue_rug"]).all()
    assert on([*things["cow"], *things["bench"]], things["road_tile"]).all()


def test_a_flat_stands_within_walls() -> None:
    walls = {
        "Plain Wall300": (3.0, 0.14, 2.7),
        "Plain Wall100": (1.0, 0.14, 2.7),
        "Plain Wall Doorway200": (2.0, 0.15, 2.7),
    }
    things = composed(prompt_of("A flat, eight by six metres: a room, a table and four chairs.", {**SIZES, **walls}))
    assert len(things["plain_wall_doorway200"]) == 1
    centres = plan_centres([thing for name in map(id_of, walls) for thing in things.get(name, [])])
    inside = plan_centres([*things["oak_table"], *things["dining_chair"]])
    assert (inside > centres.min(axis=0)).all() and (inside < centres.max(axis=0)).all()
    assert (np.ptp(centres, axis=0) >= (800, 600)).all()


def test_a_fenced_place_has_a_fence() -> None:
    assert len(composed(prompt_of("Three cows stand near a fenced pen. A barn."))["wood_fence"]) >= 8


def test_prose_that_names_nothing_shows_the_palette() -> None:
    things = composed(prompt_of("Something nice."))
    assert set(things) == {id_of(name) for name, size in SIZES.items() if size[2] > 0.12}


@pytest.mark.timeout(900)
def test_the_shipped_texts_are_composed_soundly(tmp_path_factory: pytest.TempPathFactory) -> None:
    suite = SuiteFolder(starter_home(tmp_path_factory) / "suites/starter")
    texts = [case for case in suite.suite().cases if case.setting == "text-to-scene"]
    assert len(texts) >= 4
    for case in texts:
        agent = suite.agent_case(case.alias)
        things = composed(agent.prompt, agent.plate_m or 200.0)
        assert len(things) >= 20 and intruders(things) == []


@pytest.mark.parametrize("case", ["bazaar", "case_004", "case_009", "case_011"])
def test_published_prompts_are_composed_soundly(case: str) -> None:
    task = PUBLISHED / case / "task.yaml"
    if not task.exists():
        pytest.skip("the published tasks are not on this machine")
    prompt = yaml.safe_load(task.read_text())["inputs"]["prompt"]
    things = composed(prompt, 200.0)
    assert len(things) >= 8 and intruders(things) == []
    assert set(things) <= {item.id for item in palette(prompt)}


def test_copies_without_room_together_stand_apart_within_the_walls_around_them() -> None:
    sizes = {"Skyscraper": (39.0, 29.0, 120.0), "Market Stall": (4.0, 3.0, 3.0), "Stone Wall": (4.0, 0.5, 4.0)}
    text = "Twelve skyscrapers and a market stall. Enclose the scene with a ring of very tall stone walls."
    things = composed(prompt_of(text, sizes), 200.0)
    assert len(things["skyscraper"]) > 8 and len(things["market_stall"]) == 1
    walls = things["stone_wall"]
    inner = [thing for key in ("skyscraper", "market_stall") for thing in things[key]]
    for axis in (0, 1):
        assert min(wall.low[axis] for wall in walls) <= min(thing.low[axis] for thing in inner)
        assert max(wall.high[axis] for wall in walls) >= max(thing.high[axis] for thing in inner)
    assert intruders(things) == []
