"""Embodied utility: panels, changes, alignment (checks K276 to K374)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from bench.reproduction.book import Book
from bench.reproduction.figure import HALF, Draft, holds, number, same, seen
from bench.reproduction.scores import GEMINI
from c4s.stats.bootstrap import Floats
from c4s.stats.navigation import UtilityMean, alignment, utility, utility_mean

SOL, OFF = "GPT-5.6 Sol (high)", "Gemma 4 31B (thinking off)"
PANELS = {"A": "eus_A_construction", "B": "eus_B_outdoor_edit"}
SCORED_SUM = 0.05
"""How far printed means may put the sums of a panel's row apart."""


def records_of(row: Any) -> Floats:
    """Scenes of a panel's row: what was scored with the value that gives the printed measured mean, zeros, withheld."""
    measured = row.scored + row.zero
    value = row.measured * measured / row.scored
    return np.array([value] * row.scored + [0.0] * row.zero + [np.nan] * row.withheld)


def panel_a(book: Book) -> Iterator[Draft]:
    """Construction."""
    yield from _panel(book, "A")


def panel_b(book: Book) -> Iterator[Draft]:
    """Outdoor repairs, with the change against the input and the other panels."""
    yield from _panel(book, "B")
    construction, outdoor = (_means(book, name) for name in PANELS)
    printed = {str(row.agent): float(row.eus) for row in book.tables[PANELS["B"]].itertuples()}
    baseline = book.tables["eus_input_baseline"].set_index("quantity")["value"]["outdoor_input_mean_eus"]
    change = {agent: value - baseline for agent, value in printed.items()}
    others = [value for agent, value in change.items() if agent != GEMINI]
    yield number(f"{GEMINI}: change against the input", change[GEMINI], note=f"ours {outdoor[GEMINI].conservative:.4f}")
    yield number(f"{SOL}: change against the input", change[SOL])
    yield number("smallest change of the others", min(others))
    yield number("largest change of the others", max(others))
    whole = {str(row.agent): float(row.eus) for row in book.tables[PANELS["A"]].itertuples()}
    note = f"ours {construction[GEMINI].conservative - construction[SOL].conservative:.4f}"
    yield number("construction: difference of the two", whole[GEMINI] - whole[SOL], note=note)
    rooms = book.tables["eus_C_indoor_rooms"]
    ends = [rooms[name].agg(kind) for name in ("rooms_measured", "mean_eus") for kind in ("min", "max")]
    told = book.checks["published"]["K362"].strip("()").split(", ")
    yield same("rooms: fewest and most, smallest and largest mean", ends, [float(value) for value in told])


def _panel(book: Book, name: str) -> Iterator[Draft]:
    table, means = book.tables[PANELS[name]], _means(book, name)
    for row in table.itertuples():
        mean = means[str(row.agent)]
        yield number(f"{row.agent}: conservative mean", mean.conservative, HALF * mean.coverage)
        yield number(f"{row.agent}: coverage, percent", 100 * mean.coverage)
        yield number(f"{row.agent}: records", mean.records)
        yield holds(
            f"{row.agent}: mean utility is no more than A", f"{mean.measured:.3f}", row.measured <= row.A + 2 * HALF
        )
    too_much = [
        str(row.agent)
        for row in table.itertuples()
        if row.measured * (row.scored + row.zero) > row.A * row.scored + SCORED_SUM
    ]
    yield seen("A over scored records alone could not be", too_much, "so A counts certified zeros")
    withheld = [mean.withheld for mean in means.values()]
    check = {"A": "K313", "B": "K351"}[name]
    yield same("fewest and most withheld", str((min(withheld), max(withheld))), book.checks["published"][check])
    if name == "B":
        least = int(book.checks["published"]["K352"].removeprefix(">= "))
        yield holds("meshes that did not settle are among the withheld", sum(withheld), sum(withheld) >= least)
    marks = book.tables["eus_shading"].query("panel == @name")
    for shade in marks.itertuples():
        order = table.sort_values(str(shade.column), ascending=False)["agent"].tolist()
        yield same(f"{shade.column}: best and second", order[:2], [shade.best, shade.second])


def _means(book: Book, name: str) -> dict[str, UtilityMean]:
    return {str(row.agent): utility_mean(records_of(row)) for row in book.tables[PANELS[name]].itertuples()}


def example(book: Book) -> Iterator[Draft]:
    """The illustrated scenes, and how near is near in a small one."""
    told = book.constants["eus"]
    for name, slack in (("left", 0.0), ("right", 0.0017)):
        scene = told["example"][name]
        yield number(f"{name} scene", utility(scene["A"], scene["routes_done"], scene["routes"]), slack)
    radius = told["arrival_radius_cm"]
    half = told["small_scene"]["half_extent_below_cm"]
    near = min(max(radius["fraction_of_smaller_half_extent"] * half, radius["floor"]), radius["cap"])
    yield number("arrival radius where small scenes end, cm", near)


def aligned(book: Book) -> Iterator[Draft]:
    """Utility of construction against the score of the full suite."""
    table = book.by_agent(PANELS["A"])
    scores = {side: book.column("public-private", "both", "configurations", f"{side}_all") for side in ("t2s", "model")}
    nine = [str(agent) for agent in table.index if agent in book.ten()]
    eight = [agent for agent in nine if agent != OFF]
    study = "the study's score summary is older than the tables"
    for name, column, agents in (
        ("eight", "eus", eight),
        ("nine", "eus", nine),
        ("eight, measured only", "measured", eight),
    ):
        found = {side: _alignment(table, column, agents, own) for side, own in scores.items()}
        ends = _rounding(table[column], agents, scores["t2s"])
        yield number(f"{name}: Pearson's r", found["t2s"][0], reach=ends, note=study)
        yield number(f"{name}: Spearman's rho", found["t2s"][1])
        yield seen(f"{name}: Spearman's rho with S_model", f"{found['model'][1]:.6f}", "another reading of the score")


def _alignment(table: Any, column: str, agents: Sequence[str], scores: dict[str, float]) -> tuple[float, float]:
    ours = alignment(table[column][list(agents)].to_numpy(dtype=float), np.array([scores[agent] for agent in agents]))
    return ours.pearson or 0.0, ours.spearman or 0.0


def _rounding(utilities: Any, agents: Sequence[str], scores: dict[str, float]) -> list[float]:
    """Pearson's r at every corner of the scores' rounding."""
    given = utilities[list(agents)].to_numpy(dtype=float)
    base = np.array([scores[agent] for agent in agents])
    corners = np.array(np.meshgrid(*[[-HALF, HALF]] * len(agents))).reshape(len(agents), -1).T
    found = [alignment(given, base + corner).pearson or 0.0 for corner in corners]
    return [float(value) for value in np.linspace(min(found), max(found), 200)]
