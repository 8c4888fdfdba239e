"""Who ranks what: the properties that the paper states of its design, for any seed."""

from __future__ import annotations

from collections import Counter
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.stats.human import POINTS, HumanOrder, Preferences, blocks, fano_plane, split

PAIRS = {frozenset(pair) for pair in combinations(range(POINTS), 2)}


@given(st.integers(0, 2**32), st.integers(1, 20))
def test_blocks_are_balanced_for_any_seed(seed: int, prompts: int) -> None:
    """Seven triplets a prompt, every candidate in three, every pair in one; three annotators each, three tasks each,
    and any two annotators share one triplet of a prompt."""
    for drawn in blocks(prompts, seed):
        assert len(drawn) == POINTS
        for points in ([block.candidates for block in drawn], [block.annotators for block in drawn]):
            assert Counter(point for block in points for point in block) == dict.fromkeys(range(POINTS), 3)
            pairs = Counter(frozenset(pair) for block in points for pair in combinations(block, 2))
            assert pairs == dict.fromkeys(PAIRS, 1)


def test_the_papers_study_has_the_papers_numbers() -> None:
    """16 prompts: 336 triplet rankings and 1,008 preferences, each pair of each prompt by three annotators."""
    orders = [
        HumanOrder(prompt, annotator, block.candidates)
        for prompt, drawn in enumerate(blocks(16, 20_260_915))
        for block in drawn
        for annotator in block.annotators
    ]
    preferences = Preferences.of(orders, 16, POINTS)
    assert (len(orders), len(preferences)) == (336, 1008)
    votes = preferences.units()
    assert len(votes.won) == 16 * 21 and set((votes.won + votes.lost).tolist()) == {3.0}
    assert sum(map(sum, votes.weights())) == pytest.approx(1.0)


def test_the_seed_alone_decides_and_prompts_differ() -> None:
    assert blocks(16, 5) == blocks(16, 5) != blocks(16, 6)
    assert blocks(16, 5)[:4] == blocks(4, 5)
    assert len({tuple(block.candidates for block in drawn) for drawn in blocks(16, 5)}) == 16
    assert {frozenset(block) for block in fano_plane()} != {frozenset(b.candidates) for b in blocks(1, 5)[0]}


@given(st.integers(0, 2**32), st.integers(2, 40), st.data())
def test_a_split_takes_every_prompt_once(seed: int, prompts: int, data: st.DataObject) -> None:
    held_out = data.draw(st.integers(1, prompts - 1))
    development, holdout = split(prompts, seed, held_out)
    assert sorted(development + holdout) == list(range(prompts)) and len(holdout) == held_out
    assert split(prompts, seed, held_out) == (development, holdout)


@pytest.mark.parametrize(("prompts", "held_out"), [(4, 4), (4, 0), (1, 1)])
def test_a_split_without_a_side_is_refused(prompts: int, held_out: int) -> None:
    with pytest.raises(ValueError, match="either side"):
        split(prompts, 1, held_out)


@given(st.permutations(range(3)), st.integers(0, 2))
def test_a_triplet_is_three_preferences_that_give_it_again(order: list[int], annotator: int) -> None:
    found = Preferences.of([HumanOrder(0, annotator, tuple(order))], 1, 3)
    wins = Counter(
        first if sign > 0 else second for first, second, sign in zip(found.first, found.second, found.sign, strict=True)
    )
    assert len(found) == 3 and sorted(range(3), key=lambda one: -wins[one]) == order


@pytest.mark.parametrize("wrong", [HumanOrder(0, 0, (1, 1, 2)), HumanOrder(1, 0, (0, 1, 2)), HumanOrder(0, 0, (0, 3))])
def test_what_is_no_ranking_of_the_study_is_refused(wrong: HumanOrder) -> None:
    with pytest.raises(ValueError, match="ranking"):
        Preferences.of([wrong], 1, 3)
