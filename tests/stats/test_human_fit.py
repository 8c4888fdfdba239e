"""The weight fit: what it may choose, what it compares, and that planted weights are recovered."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bench.made_people import SURE, planted_scores, rankings, scenes
from c4s.protocol.rules import FAMILY_WEIGHTS, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS, T2S_WEIGHTS
from c4s.stats.human import (
    ADOPTED,
    POINTS,
    PROPOSALS,
    HumanOrder,
    Objective,
    Preferences,
    SavedOverview,
    SavedScene,
    SceneTable,
    SubscoreWeights,
    consensus,
    feasible,
    fit,
    log_worths,
    policy_scores,
    proposals,
    score_under,
    with_scores,
)

UNIT = st.floats(0, 1)
GRID = st.integers(0, 100).map(lambda part: part / 100)
FINE = st.integers(0, 10_000).map(lambda part: part / 10_000)


@st.composite
def saved(draw: st.DrawFn) -> SavedScene:
    """Components as judges give them: many of few decimals, whose scores fall on rounding edges."""
    overview = SavedOverview(
        {name: draw(st.one_of(GRID, UNIT)) for name in OVERVIEW_WEIGHTS}, draw(GRID), draw(st.booleans())
    )
    asked = draw(st.sets(st.sampled_from(list(FAMILY_WEIGHTS)), max_size=4))
    measured = draw(st.sets(st.sampled_from(list(PHYSICS_LEAF_WEIGHTS)), max_size=2))
    return SavedScene(
        {name: draw(FINE) for name in FAMILY_WEIGHTS if name in asked},
        draw(st.one_of(st.none(), st.just(overview))),
        {name: draw(st.one_of(FINE, UNIT)) for name in PHYSICS_LEAF_WEIGHTS if name in measured},
    )


@given(st.lists(saved(), min_size=1, max_size=4), st.integers(0, 1000))
@settings(max_examples=200)
def test_scores_of_arrays_are_the_protocols_to_the_last_bit(made: list[SavedScene], seed: int) -> None:
    table = SceneTable.of(made)
    policies = np.concatenate([proposals(seed, 6), ADOPTED.hundredths()[None]])
    policies = policies[feasible(policies, table.applicable())]
    expected = [[score_under(scene, SubscoreWeights.of(policy)) for scene in made] for policy in policies]
    assert policy_scores(table, policies).tolist() == expected


def test_proposals_are_feasible_whole_hundredths_of_the_seed() -> None:
    drawn = proposals(11)
    assert len(drawn) == PROPOSALS and feasible(drawn, np.ones((1, 4), dtype=bool)).all()
    assert (drawn == proposals(11)).all() and (drawn != proposals(12)).any()
    assert len(np.unique(drawn, axis=0)) > 0.99 * PROPOSALS


def test_the_feasible_set_is_the_papers() -> None:
    """Physical share .20, Detailed share at least .20, blocks that sum to 1, and some weight on what is asked."""
    every, spatial = np.ones((1, 4), dtype=bool), np.array([[False, False, False, True]])
    adopted = ADOPTED.hundredths()
    assert feasible(adopted[None], every).all() and feasible(adopted[None], spatial).all()
    final = {name: at for at, name in enumerate(T2S_WEIGHTS)}
    for change, applicable in (
        ({10 + final["physics"]: -1, 10 + final["overview"]: 1}, every),
        ({10 + final["detailed"]: -1, 10 + final["overview"]: 1}, every),
        ({0: 1}, every),
        ({3: -20, 0: 20}, spatial),
        ({4: -41, 5: 41}, every),
    ):
        moved = adopted.copy()
        for column, by in change.items():
            moved[column] += by
        assert not feasible(moved[None], applicable).any(), change
    leaves = {"floating": 0.505, "solid_penetration": 0.495}
    with pytest.raises(ValueError, match="hundredths"):
        SubscoreWeights(ADOPTED.families, ADOPTED.dimensions, leaves, ADOPTED.final).hundredths()


def _objective(prompts: int, seed: int, taste: SubscoreWeights, sharpness: float) -> tuple[Objective, np.ndarray]:
    table = SceneTable.of(scenes(prompts, seed))
    worth = planted_scores(table, taste)
    votes = Preferences.of(rankings(worth, seed, sharpness), prompts, POINTS).units()
    return Objective(table, votes, POINTS, ADOPTED.hundredths()), worth


def test_an_objective_is_the_mean_over_prompts_pairs_and_reviewers() -> None:
    """The same as agreement within prompts, averaged; and the loss by its formula."""
    prompts, seed = 5, 3
    table = SceneTable.of(scenes(prompts, seed))
    worth = planted_scores(table, ADOPTED)
    preferences = Preferences.of(rankings(worth, seed, 10.0), prompts, POINTS)
    objective = Objective(table, preferences.units(), POINTS, ADOPTED.hundredths())
    ((agreement, loss, distance),) = objective.standings(ADOPTED.hundredths()[None])
    assert agreement == pytest.approx(with_scores(worth, preferences).mean()) and distance == 0
    gaps = worth[preferences.prompt, preferences.first] - worth[preferences.prompt, preferences.second]
    assert loss == pytest.approx(np.log1p(np.exp(-10 * preferences.sign * gaps)).mean())


def test_equal_agreement_goes_by_loss_and_then_by_distance() -> None:
    """One prompt, one pair, both leaves alike: all policies agree, and of those of one loss the nearest is best."""
    leaves = ({"floating": 1.0, "solid_penetration": 1.0}, {"floating": 0.0, "solid_penetration": 0.0})
    table = SceneTable.of([SavedScene({}, None, leaf) for leaf in leaves])
    votes = Preferences.of([HumanOrder(0, 0, (0, 1))], 1, 2).units()
    objective = Objective(table, votes, 2, ADOPTED.hundredths())
    far = ADOPTED.hundredths()
    far[8:10] = 30, 70
    (found,) = objective.ranked(np.stack([far, ADOPTED.hundredths()]), 1)
    assert (found[0] == ADOPTED.hundredths()).all()
    standings = objective.standings(np.stack([far, ADOPTED.hundredths()]))
    assert standings[0, :2].tolist() == standings[1, :2].tolist() and standings[0, 2] > standings[1, 2] == 0


@pytest.mark.parametrize("planted", [0, 1])
def test_planted_weights_are_recovered_from_many_prompts(planted: int) -> None:
    """Forty prompts, annotators who never err: agreement of at least .98, weights within .06 of the planted ones, and
    scores within .03."""
    taste = SubscoreWeights.of(proposals(17, 5)[planted])
    objective, worth = _objective(40, 4, taste, SURE)
    found = fit(objective)
    assert found.standing.agreement >= 0.98 > found.comparison.agreement
    assert np.abs(found.hundredths - taste.hundredths()).max() <= 6
    again = policy_scores(objective.scenes, found.hundredths[None])[0].reshape(worth.shape)
    assert np.abs(again - worth).max() < 0.03


def test_at_the_papers_size_a_fit_agrees_at_least_as_well_as_the_planted_weights_do() -> None:
    """Twelve prompts and noisy annotators: the planted weights are no better on what was fitted."""
    taste = SubscoreWeights.of(proposals(17, 5)[0])
    objective, _ = _objective(12, 4, taste, 30.0)
    found = fit(objective)
    ((planted, _, _),) = objective.standings(taste.hundredths()[None])
    assert found.standing.agreement >= planted - 0.005
    assert found.standing.agreement > found.comparison.agreement
    assert fit(objective).hundredths.tolist() == found.hundredths.tolist()
    assert found.looked_at["proposals"] == PROPOSALS and 1 <= found.passes <= 5
    assert feasible(found.hundredths[None], objective.applicable).all()


def test_a_second_fit_uses_consensus_labels() -> None:
    prompts, seed = 6, 5
    taste = SubscoreWeights.of(proposals(17, 5)[1])
    table = SceneTable.of(scenes(prompts, seed))
    orders = rankings(planted_scores(table, taste), seed, 25.0)
    labels = consensus(log_worths(orders, prompts, POINTS))
    objective = Objective(table, labels.units(), POINTS, ADOPTED.hundredths())
    found = fit(objective)
    scores = policy_scores(table, found.hundredths[None])[0].reshape(prompts, POINTS)
    assert found.standing.agreement == pytest.approx(with_scores(scores, labels).mean())
    assert found.standing.agreement > found.comparison.agreement
