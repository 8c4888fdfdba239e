"""The cheats build what they are said to build, whatever the catalog."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.agents.base import agent_of
from c4s.agents.cheats.agent import Cheat
from c4s.agents.cheats.layouts import BURIED_CM, LAYOUTS, LIFTED_CM, MOST, SMALL_CM, TINY_CM, CatalogItem, Placing
from c4s.protocol.baselines import BASELINES, CHEATS
from c4s.run.configurations import configuration, is_ranked

REACH_CM = 5000.0
PROMPT = "A market with twelve barrels and two carts.\n\n=== ASSET PALETTE ===\n"
sides = st.floats(5.0, 900.0)


@st.composite
def items(draw: st.DrawFn) -> list[CatalogItem]:
    names = draw(st.lists(st.sampled_from(["Barrel", "Cart", "Oak tree", "Bench", "Lamp"]), min_size=1, unique=True))
    return [
        CatalogItem(name, f"/Game/P/{number}", draw(st.booleans()), (-x / 2, -y / 3, -z / 4), (x / 2, y, z))
        for number, name in enumerate(names)
        for x, y, z in [(draw(sides), draw(sides), draw(sides))]
    ]


def bottom(placing: Placing) -> float:
    return placing.location[2] + placing.item.low[2] * placing.scale


def largest(placing: Placing) -> float:
    return max(placing.item.size) * placing.scale


def test_every_cheat_is_an_agent_that_is_never_ranked() -> None:
    assert set(CHEATS) == set(LAYOUTS) and not set(CHEATS) & set(BASELINES)
    for name in CHEATS:
        chosen = configuration(name)
        assert isinstance(agent_of(chosen), Cheat) and not is_ranked(chosen)


@given(items())
def test_each_layout_is_what_it_is_called(catalog: list[CatalogItem]) -> None:
    made = {name: layout(catalog, PROMPT, REACH_CM)[:MOST] for name, layout in LAYOUTS.items()}
    assert {placing.item for placing in made["once"]} == set(catalog)
    assert all(bottom(placing) == pytest.approx(0.0, abs=1e-6) for placing in (*made["once"], *made["parade"]))
    assert all(largest(placing) == pytest.approx(SMALL_CM) for placing in made["dust"])
    assert all(largest(placing) == pytest.approx(TINY_CM) for placing in made["pile"])
    asked = Counter(placing.item.name for placing in made["dust"])
    assert asked["Barrel"] in (0, 12) and asked["Cart"] in (0, 2) and asked["Bench"] in (0, 3)
    assert len({placing.item for placing in made["copies"]}) == 1
    assert set(Counter((placing.item, placing.location) for placing in made["instances"]).values()) <= {3}
    assert sum(not placing.collision for placing in made["ghost"]) == len(made["ghost"]) - 1
    assert all(bottom(placing) == pytest.approx(BURIED_CM) for placing in made["buried"])
    assert all(bottom(placing) == pytest.approx(LIFTED_CM) for placing in made["lifted"])
    assert all(placing.hidden for placing in made["hidden"][6:101])
    assert all(placing.scale == 1.0 for name in ("once", "heap", "parade", "buried") for placing in made[name])


@given(items())
def test_rows_touch_nothing(catalog: list[CatalogItem]) -> None:
    placed = LAYOUTS["parade"](catalog, PROMPT, REACH_CM)
    boxes = [
        [
            (placing.location[axis] + placing.item.low[axis], placing.location[axis] + placing.item.high[axis])
            for axis in (0, 1)
        ]
        for placing in placed
    ]
    for number, first in enumerate(boxes):
        for second in boxes[number + 1 :]:
            assert any(a[1] <= b[0] or b[1] <= a[0] for a, b in zip(first, second, strict=True))
