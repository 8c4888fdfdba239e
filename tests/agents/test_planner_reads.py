"""What the planner reads in a prompt's prose: which assets, how many, and what stands on or near what."""

from __future__ import annotations

import pytest

from c4s.agents.baselines.prose import read
from tests.agents.palettes import prompt_of


def links(text: str) -> set[tuple[str, str, str]]:
    return {(link.thing.noun, link.kind, link.other.noun) for link in read(prompt_of(text)).links}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A bowl stands on the table.", {("bowl", "on", "table")}),
        ("Two chairs and a bench stand beside a well.", {("chair", "near", "well"), ("bench", "near", "well")}),
        ("On the table stand a bowl and a crate.", {("bowl", "on", "table"), ("crate", "on", "table")}),
        ("A bowl stands on it, a cow near a barn.", {("cow", "near", "barn")}),
        ("A bowl or a crate stands on the table.", {("bowl", "on", "table")}),
        ("A bench marks a well.", {("bench", "near", "well")}),
    ],
)
def test_on_and_near_are_read(text: str, expected: set[tuple[str, str, str]]) -> None:
    assert links(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Four chairs around the table.",
        "A barn north of the well.",
        "A cow in the barn.",
        "A table with four chairs.",
        "A cow between two barns.",
        "Trees along the road.",
        "A barn behind the well.",
        "A fence enclosing a pasture.",
        "A cow on the far side, a barn.",
    ],
)
def test_nothing_else_is(text: str) -> None:
    assert links(text) == set()


@pytest.mark.parametrize(
    ("text", "ids", "count"),
    [
        ("Twelve chairs.", ["dining_chair"], 12),
        ("A dozen crates.", ["crate"], 12),
        ("Roughly seventeen cows.", ["cow"], 17),
        ("A red tractor.", ["tractor_red"], 1),
        ("Two tractors.", ["tractor_red", "tractor_green"], 2),
        ("A two-storey barn.", ["barn"], 1),
        ("A small pond.", ["pond_tile"], 1),
        ("A crate or a bench.", ["crate", "bench"], 1),
        ("Three teal stools.", ["teal_stool"], 3),
    ],
)
def test_nouns_name_assets_and_counts(text: str, ids: list[str], count: int) -> None:
    named = read(prompt_of(text)).named
    assert [([item.id for item in one.items], one.count) for one in named] == [(ids, count)]


def test_what_was_named_before_is_meant_again() -> None:
    named = read(prompt_of("A barn stands here. Two cows rest near the barn. Every cow has a crate.")).named
    assert [one.noun for one in named] == ["barn", "cow", "crate"]


def test_the_size_of_the_whole_is_read() -> None:
    assert read(prompt_of("A flat, twelve by eight metres, with a table.")).size_m == (12.0, 8.0)
    assert read(prompt_of("A table by the door.")).size_m is None


@pytest.mark.parametrize(
    ("text", "nouns"),
    [
        ("A barn with no roads, cows, or fences. A crate.", ["barn", "crate"]),
        ("A barn without crates stands near a well.", ["barn", "well"]),
        ("Nothing but a barn, no trees and no benches.", ["barn"]),
        ("A square timber barn.", ["barn"]),
    ],
)
def test_what_is_denied_and_what_only_describes_is_not_built(text: str, nouns: list[str]) -> None:
    assert [one.noun for one in read(prompt_of(text)).named] == nouns


def test_a_count_is_kept_before_hyphened_words_and_for_what_is_said_again() -> None:
    sizes = {"Townhouse A": (8.0, 9.0, 12.0), "Skyscrapers": (17.0, 15.0, 52.0), "Waterffall": (2.0, 1.0, 8.0)}
    text = (
        "Roughly a dozen connected mid-rise blocks. Around them a ring of roughly twenty detached high-rise towers, "
        "with towers facing inward. Thirty timber-and-stone houses. Two small waterfalls."
    )
    named = read(prompt_of(text, sizes)).named
    told = [([item.id for item in one.items], one.count) for one in named]
    assert told == [(["townhouse_a"], 12), (["skyscrapers"], 20), (["townhouse_a"], 30), (["waterffall"], 2)]
