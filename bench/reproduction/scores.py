"""Main tables, marks, paired differences, full-suite scores and difficulty (checks K001 to K157)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from bench.reproduction.book import Book
from bench.reproduction.figure import HALF, Draft, number, same
from bench.reproduction.worlds import TIERS
from c4s.protocol.case import i2s_case, t2s_case
from c4s.protocol.rules import I2S_WEIGHTS, MODEL_WEIGHTS
from c4s.records.analysis import Column, Table, Value
from c4s.stats.orders import spearman
from warehouse.analyses.tables import marks

MAIN, TABLE = "main-results", "main"
MARKED = ("semantic", "physical_t2s", "s_t2s", "repair_f1", "physical_i2s", "s_i2s", "s_model")
POINTS = 100
TEN_POINT = 0.1
"""Points that a difference of two three-decimal scores can be off by."""
ASTRA, GEMINI = "GPT-6 Astra (max)", "Gemini 3.8 Flash (high)"


def main_table(book: Book, name: str) -> Iterator[Draft]:
    """Each score column from the printed columns that it is made of."""
    table = book.tables[f"main_results_{name}"]
    model = book.column(MAIN, name, TABLE, "s_model")
    for row in table.itertuples():
        semantic = float(row.semantic)
        t2s = t2s_case(valid=True, detailed=semantic, overview=semantic, physics=float(row.physical_t2s))["score"]
        i2s = i2s_case(valid=True, repair_f1=float(row.repair_f1), physics=float(row.physical_i2s))["score"]
        yield number(f"{row.agent}: S_T2S of its parts", t2s, HALF)
        yield number(f"{row.agent}: S_I2S of its parts", i2s, HALF)
        yield number(f"{row.agent}: S_model of both", model[str(row.agent)], HALF)
    yield same("rows stand by S_model", _descends(list(table["s_model"])), True)


def public_table(book: Book) -> Iterator[Draft]:
    yield from main_table(book, "public")


def private_table(book: Book) -> Iterator[Draft]:
    yield from main_table(book, "private")


def shading(book: Book) -> Iterator[Draft]:
    """Best and second of each printed column, by our rule."""
    tiers = [f"{side}_{tier}" for side in ("t2s", "i2s") for tier in TIERS]
    for name, columns in (
        ("main_results_public", MARKED),
        ("main_results_private", MARKED),
        ("difficulty", (*tiers, "s_model")),
    ):
        printed, shades = book.by_agent(name), book.by_agent(f"{name}_shading")
        for column in columns:
            told = marks(_of_column(printed, column), Column(name=column, title=column, decimals=3, marks="high"))
            kinds = ("best", "second")
            ours = [sorted(a for a, mark in zip(printed.index, told, strict=True) if mark == kind) for kind in kinds]
            yield same(f"{name} {column}: {kinds}", ours, [sorted(shades.index[shades[column] == k]) for k in kinds])


def _of_column(printed: Any, column: str) -> Table:
    rows: list[dict[str, Value]] = [{column: float(value)} for value in printed[column]]
    return Table(name=column, title=column, columns=[], rows=rows)


def public_order(book: Book) -> Iterator[Draft]:
    """The association of the two sides, and who leads."""
    columns = {name: book.column(MAIN, "public", TABLE, name) for name in ("s_t2s", "s_i2s", "repair_f1", "s_model")}
    agents = list(columns["s_t2s"])
    t2s, i2s = (np.array([columns[name][agent] for agent in agents]) for name in ("s_t2s", "s_i2s"))
    yield number("Spearman's rho of S_T2S and S_I2S, 14 configurations", spearman(t2s, i2s) or 0.0)
    for check, name in (("K097", "s_t2s"), ("K098", "s_i2s"), ("K099", "repair_f1")):
        leader = max(agents, key=lambda agent: columns[name][agent])
        yield same(f"leader by {name}", leader, book.checks["published"][check])
    best = sorted(str(row["configuration"]) for row in book.table(MAIN, "public", TABLE).rows[:4])
    yield same("the four best", "; ".join(best), book.checks["published"]["K100"])


def paired(book: Book) -> Iterator[Draft]:
    """Differences of two configurations against the tables that they are differences of."""
    printed = book.tables["trajectory_paired"].set_index("task")
    delta = printed["delta_score"]
    scores = {name: book.column(MAIN, "public", TABLE, name) for name in ("s_t2s", "s_i2s")}
    sizes = book.tables["set_composition"].set_index("set").loc["public"]
    share = sizes["indoor"] / (sizes["indoor"] + sizes["outdoor"])
    yield number("T2S difference, points", POINTS * (scores["s_t2s"][ASTRA] - scores["s_t2s"][GEMINI]), TEN_POINT)
    i2s = share * delta["Indoor"] + (1 - share) * delta["Outdoor"]
    yield number("I2S difference of the domains' differences", i2s / POINTS, 2 * HALF)
    whole = MODEL_WEIGHTS["t2s"] * delta["Text-to-Scene"] + MODEL_WEIGHTS["i2s"] * i2s
    yield number("difference of the overall scores", whole / POINTS, 3 * HALF / 10)
    use = book.by_agent("tool_usage")
    for task, column in (("Text-to-Scene", "t2s_public"), ("Indoor", "indoor_public"), ("Outdoor", "outdoor_public")):
        yield number(f"{task}: difference in calls", use[column][ASTRA] - use[column][GEMINI], TEN_POINT)
    apart = [task for task in printed.index if printed["score_lo"][task] > 0 or printed["score_hi"][task] < 0]
    yield same("tasks whose interval leaves out 0", "; ".join(apart), book.checks["published"]["K107"])
    for agent in ("Claude Opus 5 (max)", "Claude Fable 5.1 (max)"):
        yield number(f"{agent}: mean calls of a construction", use["t2s_public"][agent])
    physical = {}
    for domain in ("Indoor", "Outdoor"):
        f1 = _f1(book, domain.lower())
        physical[domain] = (delta[domain] - I2S_WEIGHTS["repair_f1"] * POINTS * (f1[ASTRA] - f1[GEMINI])) / (
            POINTS * (1 - I2S_WEIGHTS["repair_f1"])
        )
    implied = share * physical["Indoor"] + (1 - share) * physical["Outdoor"]
    slack = (0.8 * TEN_POINT + 0.005) / 0.2 / POINTS + 2 * HALF
    yield number("difference in Physical Safety that the others imply", implied, slack)


def _f1(book: Book, domain: str) -> dict[str, float]:
    titles = {"indoor": "Image to scene, indoor", "outdoor": "Image to scene, outdoor"}
    rows = book.table("repair-rates", "domains", "rates_public").rows
    return {str(row["configuration"]): float(row["repair_f1"] or 0) for row in rows if row["domain"] == titles[domain]}


def full_suite(book: Book) -> Iterator[Draft]:
    """The full suite from both sets, and from the tiers."""
    both = {
        name: book.column("public-private", "both", "configurations", f"{name}_all") for name in ("t2s", "i2s", "model")
    }
    tiers = {name: book.column(MAIN, "tiers", TABLE, f"s_{name}") for name in ("t2s", "i2s", "model")}
    for agent in book.ten():
        yield number(f"{agent}: S_model of both sets", both["model"][agent], HALF)
        yield number(f"{agent}: S_model of the tiers", tiers["model"][agent], HALF)
        for side in ("t2s", "i2s"):
            yield number(f"{agent}: S_{side.upper()} of both sets and of the tiers", both[side][agent], 2 * HALF)


def difficulty(book: Book) -> Iterator[Draft]:
    """Means of the tiers."""
    for row in book.table("difficulty", "tiers", "means").rows:
        yield number(f"mean of {row['tier']}", float(row["mean"] or 0), HALF)
    yield same("rows stand by S_model", _descends(list(book.tables["difficulty"]["s_model"])), True)


def _descends(values: list[float]) -> bool:
    return values == sorted(values, reverse=True)
