"""Public set against the full suite, composition, sizes (checks K158 to K188, K375 to K406)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from bench.reproduction.book import Book
from bench.reproduction.figure import HALF, Draft, close, holds, number, same
from bench.reproduction.worlds import REASONS, SIDES
from c4s.records.analysis import Value

STUDY = "public-private"
NEAR, NEAR_POOLED = 0.02, 0.006
_ROUNDING = {"S_T2S": 2 / 3, "S_I2S": 85 / 80, "S_model": (2 / 3 + 85 / 80) / 2}
"""How much of half a unit a difference of a public mean and a mean of both can be off by: shares of private cases."""


def validation(book: Book) -> Iterator[Draft]:
    """The validation table, its correlation, and the pool."""
    rows = _by_score(book, "both")
    for name in ("S_T2S", "S_I2S", "S_model"):
        row, slack = rows[name], HALF * _ROUNDING[name]
        yield number(f"{name}: mean |difference|", _of(row, "mean_absolute"), slack)
        yield number(f"{name}: largest |difference|", _of(row, "largest"), slack)
        yield number(f"{name}: mean difference", _of(row, "mean"), slack)
        yield number(f"{name}: Kendall's tau", _of(row, "tau_b"), note=str(row["swapped_pairs"]))
        yield number(f"{name}: reversed pairs", _of(row, "reversed_pairs"), note=str(row["which"]))
    model = rows["S_model"]
    yield number("Pearson's r of S_model", _of(model, "pearson"), 3 * HALF / 5)
    yield number("S_model outside the pool: mean |difference|", _of(model, "outside_pool"), 0.6 * HALF)
    yield number("S_model inside the pool: mean |difference|", _of(model, "inside_pool"), 0.6 * HALF)
    public, whole = (book.column(STUDY, "both", "configurations", f"model_{kind}") for kind in ("public", "all"))
    one, two = next(
        (one, two) for one in whole for two in whole if whole[one] > whole[two] and public[one] < public[two]
    )
    yield number("gap of the one pair in another order", whole[one] - whole[two], 2 * HALF, note=f"{one} / {two}")
    printed = book.by_agent("difficulty")["s_model"]
    yield number("the same from the printed full-suite scores", abs(printed[one] - printed[two]), 2 * HALF)


def domains(book: Book) -> Iterator[Draft]:
    """Domains: only F1 is printed by domain, so only its part of the score can be compared."""
    rows, printed = _by_score(book, "domains"), book.tables["public_private_validation"].set_index("score")
    part = "F1's part of the score alone"
    titles = {"Indoor": "Image to scene, indoor", "Outdoor": "Image to scene, outdoor"}
    for domain, title in titles.items():
        for name, theirs in (("mean_absolute", "mean_abs_delta"), ("largest", "max_abs_delta"), ("mean", "mean_delta")):
            ours = _of(rows[title], name)
            yield close(f"{domain}: {name.replace('_', ' ')}", ours, float(printed[theirs][domain]), NEAR, part)
        order = f"Physical Safety by domain is not printed; F1 alone gives tau {_of(rows[title], 'tau_b'):.3f}"
        yield Draft(f"{domain}: order and reversed pairs", None, status="not_recomputable", note=order)
    pooled = rows["S_I2S, domains equal"]
    for name, check in (("mean_absolute", "K186"), ("largest", "K187")):
        published = float(book.checks["published"][check])
        yield close(f"domains equal: {name.replace('_', ' ')}", _of(pooled, name), published, NEAR_POOLED, part)
    full = book.column(STUDY, "domains", "configurations", f"{SIDES['outdoor']}_all")
    gap = full["Muse Spark 1.3 (medium)"] - full["DeepSeek V4.1 Flash (high)"]
    yield holds("full outdoor gap of the reversed pair, F1's part", f"{gap:.4f}", gap > 0, part)


def _by_score(book: Book, suite: str) -> Mapping[str, Mapping[str, Value]]:
    return {str(row["score"]): row for row in book.table(STUDY, suite, "validation").rows}


def _of(row: Mapping[str, Value], name: str) -> float:
    return float(row[name] or 0)


def counts(book: Book) -> Iterator[Draft]:
    """Sums of counts and the sets' weights."""
    groups = book.tables["operation_group_counts"]
    for domain in ("indoor", "outdoor"):
        yield number(f"{domain} categories", groups[domain].sum())
    yield number("outdoor chain lengths", book.tables["chain_length_counts"]["outdoor_cases"].sum())
    printed = book.tables["set_composition"].set_index("set")
    for row in book.table("cohorts", "both", "cohorts").rows:
        name = str(row["set"])
        yield number(f"{name}: cases", _of(row, "cases"))
        weights = (str(row["indoor_weight"]), str(row["outdoor_weight"]))
        wanted = (str(printed["indoor_weight_in_i2s"][name]), str(printed["outdoor_weight_in_i2s"][name]))
        yield same(f"{name}: weights of the domains", " / ".join(weights), " / ".join(wanted))
        yield number(f"{name}: pairs", _of(row, "pairs"))
    suite = book.constants["suite"]["i2s_source_scenes"]
    yield number("editing cases", suite["total"] * suite["tasks_per_scene"])
    for setting in book.table("difficulty", "tiers", "counts").rows:
        yield number(f"{setting['setting']}: cases of the tiers", _of(setting, "cases"))
    sums = {str(row["reason"]): _of(row, "trials") for row in book.table("zero-reasons", "zeros", "sums_public").rows}
    for column, code in REASONS.items():
        yield number(f"zeros: {column.replace('_', ' ')}", sums[code])
    yield number("zeros: all", sums["total"])
    zeros = book.table("zero-reasons", "zeros", "zeros_public").rows
    fits = all(sum(_of(row, code) for code in REASONS.values()) == row["total"] for row in zeros)
    yield same("zeros: reasons of each configuration add up", fits, True)


def sizes(book: Book) -> Iterator[Draft]:
    """The nested sets."""
    table = book.tables["public_set_sizes"]
    whole = sum(book.tables["set_composition"].set_index("set").loc["full", list(SIDES)])
    for row in table.itertuples():
        yield number(f"{row.cases} cases: composition", row.t2s + row.indoor + row.outdoor)
        yield number(f"{row.cases} cases: kept, percent", 100 * row.cases / whole)
    nested = all((table[side].diff().dropna() >= 0).all() for side in SIDES)
    yield holds("each set holds the smaller ones' numbers of cases", nested, nested)
    marks = book.constants["sets"]["selection"]["external_marks"]
    low, high = marks["reduction_pct"]
    fits = [
        str(row.cases)
        for row in table.itertuples()
        if low <= 100 - 100 * row.cases / whole <= high
        and max(row.total_error, row.component_error) <= marks["average_error"]
    ]
    yield same("sizes that meet both outside marks", "; ".join(fits), book.checks["recomputed"]["K406"])
