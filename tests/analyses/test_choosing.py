"""Choosing public cases: nested, better than its rivals where scores have structure, and read by a suite file."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bench.made_warehouse import SUITE, MadeWarehouse
from c4s.errors import BadInput
from c4s.files import read_yaml
from c4s.protocol.settings import SETTINGS
from c4s.stats.selection import apportioned, greedy_order, left_out, lowest, normalised_error, plain, replaced
from cases.workshop.document import SelectionFile
from warehouse.analyses.choosing import counts_of, pools_of, select, trials_of
from warehouse.analyses.scope import WantedScope

FULL = ((SETTINGS[0], 30, 30), (SETTINGS[1], 80, 10), (SETTINGS[2], 80, 10))
ABILITIES = (0.7, 0.6, 0.55, 0.5, 0.4, 0.3)
PENDING = frozenset({("agent-06", "indoor-03")})


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home with a warehouse of 190 cases; the last configuration lacks an indoor one."""
    home = tmp_path_factory.mktemp("home")
    MadeWarehouse(home / "warehouse", ABILITIES, FULL, pending=PENDING).write()
    return home


def factors(seed: int, cases: int = 80, agents: int = 8) -> np.ndarray:
    """Scores that two traits of each case explain up to a little noise, shape (cases, configurations, 1)."""
    random = np.random.default_rng(seed)
    traits, skills = random.normal(0, 0.15, (cases, 2)), random.random((2, agents))
    return np.clip(0.5 + traits @ skills + random.normal(0, 0.02, (cases, agents)), 0, 1)[:, :, None]


@pytest.mark.parametrize("seed", range(5))
def test_where_two_traits_explain_the_scores_greedy_halves_the_error_of_random_sets(seed: int) -> None:
    values, random = factors(seed), np.random.default_rng(seed)
    truth = values.mean(axis=0)
    greedy = left_out(values, lambda pool: plain(len(pool), greedy_order(pool.reshape(len(pool), -1))[:20]))
    drawn = left_out(values, lambda pool: lowest(random.random((500, len(pool))), 20))
    assert np.abs(greedy - truth).mean() < np.abs(drawn - truth).mean() / 2


def test_an_error_of_one_is_what_random_sets_of_the_size_differ_by() -> None:
    values, random = np.random.default_rng(1).random((40, 1)), np.random.default_rng(2)
    errors = [normalised_error(values, random.permutation(40)[:10]) for _ in range(4000)]
    assert np.sqrt(np.mean(np.square(errors))) == pytest.approx(1, abs=0.04)
    assert normalised_error(values, np.arange(40)) == 0


@given(st.integers(0, 10**6), st.integers(3, 14), st.data())
@settings(max_examples=60)
def test_a_withdrawn_case_is_replaced_by_the_one_that_fits_best_and_no_other_changes(
    seed: int, cases: int, data: st.DataObject
) -> None:
    values = np.random.default_rng(seed).random((cases, 3))
    order = greedy_order(values)
    size = data.draw(st.integers(1, cases - 1))
    gone = data.draw(st.integers(0, cases - 1))
    new = replaced(values, order, gone, size)
    assert sorted(new) == [place for place in range(cases) if place != gone]
    kept = set(order[:size].tolist()) - {gone}
    assert kept <= set(new[:size].tolist()) and len(new[:size]) == min(size, cases - 1)
    if gone in order[:size]:
        left = np.delete(np.arange(cases), gone)

        def error(chosen: list[int]) -> float:
            return normalised_error(values[left], np.searchsorted(left, np.array(chosen)))

        assert error(new[:size].tolist()) <= min(error([*kept, one]) for one in order[size:].tolist()) + 1e-12
    else:
        assert list(new[:size]) == list(order[:size])


@given(st.lists(st.integers(1, 90), min_size=1, max_size=4))
@settings(max_examples=40)
def test_shares_of_a_larger_size_hold_those_of_a_smaller(counts: list[int]) -> None:
    found = [apportioned(size, counts) for size in range(sum(counts) + 1)]
    for small, large in pairwise(found):
        assert sum(large) == sum(small) + 1 and all(few <= many for few, many in zip(small, large, strict=True))
    assert found[-1] == counts


def test_the_papers_sets_are_nested_and_err_less_than_random_ones(home: Path) -> None:
    scope, trials = trials_of(home / "warehouse", WantedScope(suite=SUITE))
    pools = pools_of(trials)
    assert [len(pool.agents) for pool in pools] == [6, 5, 6], "who lacks an indoor case is left out indoors only"
    sizes = counts_of([], pools)
    assert [sum(counts) for counts in sizes] == [61, 75, 95, 128]
    found = select(scope, pools, sizes, sizes[2], seed=1)
    for small, large in pairwise(found.sets):
        assert set(small.cases) < set(large.cases) and len(large.cases) == sum(large.counts)
    errors = {(row.method, row.cases): row.part_error for row in found.errors}
    assert {method for method, _ in errors} == {"greedy", "random", "stratified", "anchors", "middle scores"}
    for counts in sizes:
        assert errors["greedy", sum(counts)] < errors["random", sum(counts)] / 1.1
        assert errors["random", sum(counts)] < errors["middle scores", sum(counts)]


def test_withdrawn_cases_are_in_no_set_and_the_kept_set_keeps_its_size(home: Path) -> None:
    scope, trials = trials_of(home / "warehouse", WantedScope(suite=SUITE))
    pools = pools_of(trials)
    sizes = counts_of(["20/25/50", "25/40/60"], pools)
    before = select(scope, pools, sizes, sizes[0], seed=1).sets[0]
    gone = before.cases[:2]
    found = select(scope, pools, sizes, sizes[0], withdrawn=gone, seed=1)
    after = found.sets[0]
    taken = [found.withdrawn[case] for case in gone]
    assert set(after.cases) == set(before.cases) - set(gone) | set(taken) and len(after.cases) == 95
    assert set(after.cases) < set(found.sets[1].cases) and not set(gone) & set(found.sets[1].cases)
    with pytest.raises(BadInput, match="unknown case 'nowhere'"):
        select(scope, pools, sizes, sizes[0], withdrawn=["nowhere"], seed=1)


@pytest.mark.parametrize(
    ("sizes", "told"),
    [
        (["lots"], "no size"),
        (["191"], "191 of 190"),
        (["2"], "cannot give 0"),
        (["20/25"], "names 2 settings"),
        (["20/25/81"], "cannot give 81"),
        (["20/25/50", "19/40/60"], "nested"),
    ],
)
def test_sizes_that_cannot_be_are_refused(home: Path, sizes: list[str], told: str) -> None:
    _, trials = trials_of(home / "warehouse", WantedScope(suite=SUITE))
    with pytest.raises(BadInput, match=told):
        counts_of(sizes, pools_of(trials))


def test_the_command_writes_what_a_suite_file_reads(home: Path, tmp_path: Path) -> None:
    def run(*arguments: object, code: int = 0) -> str:
        done = subprocess.run(
            [sys.executable, "-m", "c4s.cli", "suite", "select", *map(str, arguments)],
            env={**os.environ, "C4S_HOME": str(home), "COLUMNS": "160"},
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
        assert done.returncode == code, done.stderr
        return done.stdout + (done.stderr if code else "")

    out = tmp_path / "selection.yaml"
    told = json.loads(run(SUITE, "--size", "20/25/50", "--out", out, "--json"))
    file = SelectionFile.parse(read_yaml(out, what="selection"))
    assert told["written"] == str(out) and told["public"] == 95 and len(file.visibility) == 190
    assert {case for case, seen in file.visibility.items() if seen == "public"} == set(file.sets[0].cases)
    assert "something here already" in run(SUITE, "--size", "95", "--out", out, code=2)
