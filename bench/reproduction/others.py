"""Human study, repeats, running cases, behaviour and restated values (checks K407 to K503)."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from typing import Any, Final, cast

from bench.reproduction.book import Book
from bench.reproduction.figure import HALF, Draft, close, half_up, holds, number, same, seen
from bench.reproduction.scores import ASTRA, GEMINI, MAIN, TABLE
from bench.reproduction.utility import PANELS, SOL
from bench.reproduction.worlds import REPAIR_SIDES, SIDES
from c4s.protocol.case import i2s_case, t2s_case
from c4s.protocol.overview import overview_score
from c4s.protocol.repair import NOMINAL
from c4s.protocol.rules import FAMILY_WEIGHTS, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS, SEVERE_CAP, T2S_WEIGHTS
from c4s.verify.repair.counts import RepairResult

MUSE, FABLE, OPUS = "Muse Spark 1.3 (medium)", "Claude Fable 5.1 (max)", "Claude Opus 5 (max)"
BLOCKS: Final[Mapping[str, Mapping[Any, float]]] = {
    "wD": FAMILY_WEIGHTS,
    "wO": OVERVIEW_WEIGHTS,
    "wP": PHYSICS_LEAF_WEIGHTS,
    "final": T2S_WEIGHTS,
}
"""Adopted weights by the blocks of the printed table."""


def human_design(book: Book) -> Iterator[Draft]:
    """Blocks of three of seven."""
    told = book.constants["human_alignment"]
    size, triplets = told["candidates_per_task"], told["design"]["triplets"]
    rankings = told["prompts"] * triplets * told["annotators_per_triplet"]
    yield number("rankings", rankings)
    yield number("preferences of pairs", rankings * math.comb(size, 2))
    yield number("scenes", told["prompts"] * told["configurations"])
    yield number("pairs of configurations", math.comb(told["configurations"], 2))
    yield number("pairs that the triplets cover", triplets * math.comb(size, 2))


def human_fit(book: Book) -> Iterator[Draft]:
    """Shares of agreement as whole numbers of pairs."""
    told = book.constants["human_alignment"]
    pairs = math.comb(told["configurations"], 2)
    each = told["annotators_per_triplet"]
    holdout, development = told["split"]["holdout"] * pairs, told["split"]["development"] * pairs
    sizes = {"dev_individual": development * each, "holdout_individual": holdout * each, "holdout_pl": holdout}
    for row in book.tables["human_fit_results_B"].itertuples():
        for column, size in sizes.items():
            printed = float(getattr(row, column))
            agreed = round(printed * size)
            same_digits = half_up(agreed / size, 4) == round(printed, 4)
            yield same(f"{row.policy} {column}: {agreed}/{size}", same_digits, True)
        agreed = round(float(row.holdout_pl) * holdout)
        yield number(f"{row.policy}: tau-b of {agreed}/{holdout}", 2 * agreed / holdout - 1)
    adopted = int(str(told["results"]["policy_holdout_pl"]).split("/")[0])
    yield number("adopted policy on the holdout, percent", 100 * adopted / holdout)
    for end in told["results"]["ci_pct"]:
        agreed = round(end / 100 * holdout)
        yield number(f"end of its interval: {agreed}/{holdout}, percent", 100 * agreed / holdout)
    agreement = {"interannotator_holdout": holdout * each, "interannotator_all": (holdout + development) * each}
    shares = {}
    for name, size in agreement.items():
        agreed = round(told["results"][name] * size)
        shares[name] = agreed / size
        yield number(f"{name.replace('_', ' ')}: {agreed}/{size}, percent", 100 * agreed / size)
    alpha = 1 - (1 - shares["interannotator_all"]) / 0.5
    yield close(
        "Krippendorff's alpha",
        alpha,
        told["results"]["krippendorff_alpha"],
        0.01,
        "with half as chance; labels' shares are not printed",
    )


def weight_sums(book: Book) -> Iterator[Draft]:
    """Each block of weights sums to 1, and the adopted ones are ours."""
    table = book.tables["human_alignment_weights"]
    for block, rows in table.groupby("block"):
        for policy in ("adopted", "individual_fit", "pl_fit"):
            ours = sorted(BLOCKS[str(block)].values())
            note = "the protocol's own" if policy == "adopted" and sorted(rows["adopted"]) == ours else ""
            total = sum(ours) if note else float(rows[policy].sum())
            yield number(f"{block} {policy}: sum", total, note=note)


def repeatability(book: Book) -> Iterator[Draft]:
    """Repeats of the judge: numbers of scores, and tau-b of few discordant pairs."""
    told, agents = book.constants["repeatability"], book.tables["agents"]
    yield number("scores", told["configurations"] * len(told["prompts"]) * told["repeats"])
    yield number("scenes", told["configurations"] * len(told["prompts"]))
    pairs = math.comb(told["configurations"], 2)
    for tau in sorted(set(told["pairwise_tau_b"])):
        discordant = round((1 - tau) / 2 * pairs)
        yield number(f"tau-b of {discordant} discordant of {pairs}", 1 - 2 * discordant / pairs)
    cohort = agents["repeatability_study"] == "yes"
    yield number("configurations", int(cohort.sum()))
    yield number("public configurations that are left out", int(((agents["public"] == "yes") & ~cohort).sum()))
    yield number("configurations of the human study", int((agents["human_study"] == "yes").sum()))


def running_cases(book: Book) -> Iterator[Draft]:
    """Scores of the cases that are shown, and the worked example."""
    for row in book.tables["running_cases"].itertuples():
        what = f"{row.case} / {row.agent}"
        if row.setting == "T2S":
            made = t2s_case(valid=True, detailed=row.detailed, overview=row.overview, physics=row.physics)
            yield number(what, made["score"], HALF)
        else:
            f1 = _result(int(row.tp), int(row.fp), int(row.fn)).f1
            yield number(f"{what}: F1", f1)
            yield number(f"{what}: score", i2s_case(valid=True, repair_f1=f1, physics=float(row.physics))["score"])
    told = book.constants["repair_f1"]["worked_example"]
    counts = (
        told["m"] + told["d"],
        told["C"] - told["m"] + told["o"],
        told["n_plus"] - told["m"] + told["n_minus"] - told["d"],
    )
    yield same("example: TP, FP, FN", counts, (told["TP"], told["FP"], told["FN"]))
    yield number("example: F1", _result(*counts).f1)


def _result(tp: int, fp: int, fn: int) -> RepairResult:
    none = cast(Any, None)
    return RepairResult(none, NOMINAL, tp, fp, fn, {}, frozenset(), (), frozenset(), ())


def anchors(book: Book) -> Iterator[Draft]:
    """Whether printed Overview scores can come of ratings at the five anchors."""
    steps = book.constants["overview_alignment"]["anchors"]
    reached = set()
    for ratings in itertools.product(steps, repeat=len(OVERVIEW_WEIGHTS)):
        named = dict(zip(OVERVIEW_WEIGHTS, ratings, strict=True))
        for structure in steps:
            score = overview_score(named, structure, False)["score"]
            reached |= {score, min(score, SEVERE_CAP)}
    shown = book.tables["running_cases"].query("setting == 'T2S'").overview
    for value in shown:
        found = any(abs(score - value) <= HALF for score in reached)
        yield seen(
            f"Overview {value:g} from anchors alone", "yes" if found else "no", "ratings lie between anchors too"
        )


def cost(book: Book) -> Iterator[Draft]:
    """Cases whose use is known."""
    told, sizes = book.constants["cost"], book.tables["set_composition"].set_index("set").loc["public"]
    outdoor = int(str(told["coverage"]["astra_outdoor"]).split("/")[0])
    ours = int(sizes["t2s"] + sizes["indoor"]) + outdoor
    yield Draft(
        "cases with usage, were only Outdoor incomplete", float(ours), status="open", note="four more are missing"
    )


def behaviour(book: Book) -> Iterator[Draft]:
    """Numbers that cannot exceed each other."""
    for row in book.tables["python_operations_t2s_public"].itertuples():
        nested = row.scripts_with_pose_editing <= row.parseable_scripts <= row.python_requests
        counts = (row.scripts_with_pose_editing, row.parseable_scripts, row.python_requests)
        yield holds(f"{row.agent}: scripts that move, that parse, all", counts, nested)
    use = book.by_agent("tool_usage")
    for row in book.tables["resource_budgets"].itertuples():
        columns = [name for name in use.columns if name.startswith(str(row.setting).lower())]
        most = float(use[columns].max().max())
        yield holds(f"{row.setting}: largest mean of calls is within the budget", most, most <= row.tool_calls)


def restated(book: Book) -> Iterator[Draft]:
    """Values of the text against the cells of the tables, as the studies give them."""
    column = {name: book.column(MAIN, "public", TABLE, name) for name in ("s_t2s", "s_i2s", "repair_f1")}
    for agent, name in ((FABLE, "s_t2s"), (GEMINI, "s_i2s"), (ASTRA, "s_t2s"), (GEMINI, "s_t2s"), (ASTRA, "s_i2s")):
        yield number(f"{agent}: {name}", column[name][agent])
    yield number("best F1", max(column["repair_f1"].values()))
    yield number(f"{OPUS}: s_t2s", column["s_t2s"][OPUS])
    panels = {name: book.by_agent(table) for name, table in PANELS.items()}
    for panel, name in (("B", "W"), ("B", "A"), ("B", "eus"), ("A", "eus")):
        for agent in (GEMINI, SOL):
            yield number(f"panel {panel}, {agent}: {name}", panels[panel][name][agent])
    from_weight = float(
        book.tables["human_fit_results_A"].query("question == 'repair_weight_sensitivity'")["value_1"].iloc[0]
    )
    rows = [
        row
        for row in book.table("weight-sensitivity", "public", "sensitivity_public").rows
        if float(row["weight"] or 0) >= from_weight
    ]
    yield number("weights from a half on: smallest rho", min(float(row["spearman"] or 0) for row in rows))
    yield number("weights from a half on: largest shift", max(float(row["largest_shift"] or 0) for row in rows))
    sizes = book.tables["public_set_sizes"].query("adopted == 'yes'").iloc[0]
    yield number("adopted set: error of totals", sizes["total_error"])
    yield number("adopted set: error of components", sizes["component_error"])
    scores = {str(row["score"]): row for row in book.table("public-private", "both", "validation").rows}
    for name in ("S_model", "S_I2S"):
        for error in ("mean_absolute", "largest"):
            yield number(f"{name}: {error.replace('_', ' ')}", float(scores[name][error] or 0))


def side_conditions(book: Book) -> Iterator[Draft]:
    """What else has to hold between printed numbers."""
    limits = book.tables["repair_robustness_B"].set_index("setting")
    counts = [int(limits["all_targets_recovered"][name]) for name in ("strict", "default", "relaxed")]
    yield holds("complete recoveries grow with the limits", counts, counts == sorted(counts))
    fewer = limits["with_fp"]["default"] - limits["with_fp"]["default_excl_asset_material"]
    yield number("leaving out assets and materials spares", fewer)
    found = book.constants["statistics"]
    sources = found["clusters"]["indoor"] + found["clusters"]["outdoor"]
    affected = found["selective_repair"]["clusters"]
    yield holds("affected sources are among all", affected, affected <= sources)
    artefact = book.constants["repair_f1"]["export_artifact"]
    ten = len(book.ten())
    every = len(book.tables["main_results_public"])
    private = artefact["affected_submissions"] - artefact["affected_public"]
    tasks = artefact["indoor_tasks"]
    fits = [
        public
        for public in range(tasks + 1)
        if artefact["affected_public"] <= every * public and private <= ten * (tasks - public)
    ]
    yield holds("public tasks that the export artefact's numbers allow", fits, bool(fits))
    yield _domain_gap(book)
    recall = book.tables["repair_prf_by_domain"].set_index(["agent", "domain", "set"])["recall"]
    outdoor = int(book.tables["set_composition"].set_index("set")["outdoor"]["public"])
    absent = int(book.tables["invalid_breakdown"].query("agent == @MUSE")["no_submission"].iloc[0])
    submitted = recall[MUSE, "outdoor", "public"] * outdoor / (outdoor - absent)
    yield seen(f"{MUSE}: outdoor recall of what was submitted", f"{submitted:.5f}", "absent ones count 0 in the table")


def _domain_gap(book: Book) -> Draft:
    """The mean gap of the domains that the printed mean differences imply, against its part from F1."""
    mean = book.tables["public_private_validation"].set_index("score")["mean_delta"]
    public = book.tables["set_composition"].set_index("set").loc["public"]
    share = public["indoor"] / (public["indoor"] + public["outdoor"])
    implied = (mean["S_I2S"] - share * mean["Indoor"] - (1 - share) * mean["Outdoor"]) / (share - 0.5)
    full = [
        book.column("public-private", "domains", "configurations", f"{SIDES[domain]}_all") for domain in REPAIR_SIDES
    ]
    part = sum(indoor - outdoor for indoor, outdoor in zip(full[0].values(), full[1].values(), strict=True)) / len(
        full[0]
    )
    within = 0.03
    note = f"F1's part {part:.4f}"
    return holds("mean gap of the domains", f"{implied:.4f}", abs(implied - part) < within, note)
