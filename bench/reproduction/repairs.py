"""Repair by domain, robustness, conditional spatial errors and the weight of Repair F1 (checks K189 to K275)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

import numpy as np

from bench.reproduction.book import Book, column_of
from bench.reproduction.figure import HALF, Draft, holds, number, same
from bench.reproduction.scores import ASTRA, GEMINI, MAIN, TABLE
from c4s.protocol.rules import I2S_WEIGHTS
from c4s.stats.orders import WeightEffect, weight_effects
from warehouse.analyses.weight_sensitivity import WEIGHTS

TRIED: Final = 40
"""Draws of the printed parts within their rounding."""
SEED: Final = 1
NON_TARGET: Final = ("modified_non_target", "deleted_non_target", "repurposed_non_target")


def by_domain(book: Book) -> Iterator[Draft]:
    """The pooled F1 of the domains', and what complete recovery can be."""
    for name in ("public", "private"):
        pooled = book.column(MAIN, f"domains-{name}", TABLE, "repair_f1")
        for agent in book.tables[f"main_results_{name}"]["agent"]:
            yield number(f"{agent}: F1 of both domains ({name})", pooled[str(agent)], HALF)
    table = book.tables["repair_prf_by_domain"]
    too_high = int((table["f1"] > (table["precision"] + table["recall"]) / 2 + 0.1 + 1e-9).sum())
    yield same("cells whose F1 is above the mean of precision and recall", too_high, 0)
    recall = table.set_index(["agent", "domain", "set"])["recall"]
    sizes = book.tables["set_composition"].set_index("set")
    for agent in (ASTRA, GEMINI):
        share = recall[agent, "indoor", "public"] / 100
        yield number(f"{agent}: complete indoor recoveries", share * sizes["indoor"]["public"], 0.0125)
    complete = book.tables["repair_robustness_C"].set_index(["domain", "set"])["complete"]
    for domain, name in complete.index:
        cases = [recall[agent, domain, name] / 100 * sizes[domain][name] for agent in book.ten()]
        if domain == "indoor":
            yield number(f"{domain} {name}: complete recoveries", sum(math.floor(case + 0.03) for case in cases))
        else:
            bound = round(sum(cases), 2)
            yield holds(f"{domain} {name}: complete recoveries are bounded", bound, complete[domain, name] <= bound)


def robustness(book: Book) -> Iterator[Draft]:
    """Complete recoveries with false positives: shares, sums and bounds."""
    kinds = book.tables["repair_robustness_A"].set_index("change_type")
    limits, sets = book.tables["repair_robustness_B"], book.tables["repair_robustness_C"]
    for row in limits.itertuples():
        yield number(f"limits {row.setting}: share with false positives", 100 * row.with_fp / row.all_targets_recovered)
    for row in sets.itertuples():
        yield number(f"{row.domain} {row.set}: share with false positives", 100 * row.with_fp / row.complete)
    sums = sets.groupby("set")[["complete", "with_fp"]].sum()
    for name in ("public", "private"):
        yield number(f"{name}: complete recoveries of ten", sums["complete"][name])
    yield number("private: with false positives", sums["with_fp"]["private"])
    default = limits.set_index("setting").loc["default"]
    all_fp, complete = int(default["with_fp"]), int(default["all_targets_recovered"])
    of_ten = {"public_10_n134": sums["with_fp"]["public"], "private_10_n191": sums["with_fp"]["private"]}
    for column, found in {"public_14_n212": all_fp, **of_ten}.items():
        yield _union(f"kinds of false positives, {column}", kinds[column].tolist(), int(found))
    change = book.constants["statistics"]["selective_repair"]
    counted = kinds.loc[list(NON_TARGET), "public_14_n212"].tolist()
    yield _union("any change of what was no target", counted, change["non_target"])
    yield number("share with false positives, percent", 100 * all_fp / complete)
    yield number("complete without false positives", complete - all_fp)
    quoted = book.tables["complete_recovery_quoted"]
    quoted = quoted.assign(with_fp=quoted["complete"] - quoted["complete_no_fp"])
    named = quoted[quoted["agent"] != "ALL 14"].groupby("agent")[["complete", "with_fp"]].sum()
    public_only = [agent for agent in named.index if agent not in book.ten()]
    rest = complete - int(sums["complete"]["public"]) - int(named.loc[public_only, "complete"].sum())
    recall = book.tables["repair_prf_by_domain"].set_index(["agent", "domain", "set"])["recall"]
    others = [
        agent for agent in book.tables["main_results_public"]["agent"] if agent not in (*book.ten(), *named.index)
    ]
    indoor = book.tables["set_composition"].set_index("set")["indoor"]["public"]
    least = round(sum(recall[agent, "indoor", "public"] / 100 * indoor for agent in others))
    yield holds("recoveries left for the two that are not quoted", rest, rest >= least, f"at least {least} indoor")
    rest_fp = all_fp - int(sums["with_fp"]["public"]) - int(named.loc[public_only, "with_fp"].sum())
    yield holds("of them with false positives", rest_fp, rest_fp >= 0)
    for domain in ("indoor", "outdoor"):
        row = quoted[(quoted["agent"] == ASTRA) & (quoted["domain"] == domain)].iloc[0]
        yield number(f"{ASTRA}: {domain} recoveries with false positives", int(row["with_fp"]))


def _union(what: str, parts: list[int], found: int) -> Draft:
    """Overlapping kinds: all together are between the largest and the sum."""
    low, high = max(parts), sum(parts)
    return holds(f"{what}: between the largest kind and all", f"[{low}, {high}]", low <= found <= high, f"{found}")


def spatial(book: Book) -> Iterator[Draft]:
    """Requirements that are kept, and those that are mismatched."""
    told = book.constants["statistics"]["conditional_spatial"]
    yield number("mismatched of those kept, percent", 100 * told["mismatched"] / told["kept"])
    yield number("kept of all, percent", 100 * told["kept"] / told["predicates"])
    zeros = book.table("zero-reasons", "zeros", "zeros_public").rows
    invalid = sum(int(row["total"] or 0) for row in zeros if row["setting"] == "Text to scene")
    cohort = book.table("cohorts", "public", "cohorts").rows[0]
    pairs = int(cohort["configurations"] or 0) * int(cohort["t2s"] or 0) - invalid
    yield Draft("pairs with a decision", float(pairs), status="open", note=f"{told['pairs']} are told")


def weights(book: Book) -> Iterator[Draft]:
    """The order by eight weights of Repair F1."""
    rows = book.table("weight-sensitivity", "public", "sensitivity_public").rows
    reach = _reach(book)
    for number_of, row in enumerate(rows):
        weight = f"weight {row['weight']:g}"
        effects = [effect[number_of] for effect in reach]
        yield number(f"{weight}: Spearman's rho", float(row["spearman"] or 0), reach=[e.spearman or 0 for e in effects])
        yield number(f"{weight}: Kendall's tau-b", float(row["tau_b"] or 0), reach=[e.tau_b or 0 for e in effects])
        shifts = [effect.largest_shift for effect in effects]
        yield number(f"{weight}: largest rank shift", float(row["largest_shift"] or 0), reach=shifts)
        check = f"K{247 + 4 * number_of}"
        yield same(f"{weight}: leader", row["leader"], book.checks["published"][check])


def _reach(book: Book) -> list[list[WeightEffect]]:
    """The same from parts that vary within their rounding: printed ties are broken both ways."""
    table, random = book.tables["main_results_public"], np.random.default_rng(SEED)
    f1, physical = column_of(table, "repair_f1"), column_of(table, "physical_i2s")
    found = []
    for _ in range(TRIED):
        one, two = (part + random.uniform(-HALF, HALF, len(part)) for part in (f1, physical))
        found.append(weight_effects(one, two, WEIGHTS, I2S_WEIGHTS["repair_f1"]))
    return found
