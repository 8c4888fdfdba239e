"""Frozen policies on the holdout: opening it is written down, and from then on nothing can be fitted any more."""

from __future__ import annotations

from collections.abc import Mapping
from typing import get_args

import numpy as np

from c4s.errors import BadInput
from c4s.human.components import weights_of
from c4s.human.diagnostics import diagnostics
from c4s.human.fits import blocks_of
from c4s.human.study import OpenStudy
from c4s.human.tables import BOTH, DIGITS, MEASURED, intervals, known, measured_row
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.records.human import FrozenFit, HoldoutOpened, HumanEvaluation, Labels, WeightBlocks
from c4s.records.version import code_version
from c4s.stats.human import (
    ADOPTED,
    Progress,
    SubscoreWeights,
    between_annotators,
    consensus,
    log_worths,
    macro_mean,
    policy_scores,
    rho_by_prompt,
    tau_by_prompt,
    with_scores,
)

TITLES: dict[Labels, str] = {"individual": "individual fit", "consensus": "consensus fit"}
MEASURES = {
    "dev_individual": "development, individual",
    "holdout_individual": "holdout, individual",
    "holdout_consensus": "holdout, consensus",
    "holdout_tau": "holdout, tau-b",
    "holdout_rho": "holdout, rho",
}


def evaluate(opened: OpenStudy, told: Progress | None = None) -> HumanEvaluation:
    """Open the holdout and compare the adopted and all frozen weights with people.

    Raises:
        BadInput: no fit is frozen, a fit is not of this study and its development rankings or saw the holdout, a fit
            was added after the holdout was opened, or a ranking is missing.
    """
    study = opened.study
    fits = _frozen(opened)
    for part in BOTH:
        opened.complete(part)
    _open(opened, fits)
    policies = {"adopted": ADOPTED, **{TITLES[labels]: weights_of(one.weights) for labels, one in fits.items()}}
    findings = _findings(opened, policies, told)
    made = HumanEvaluation(
        study=study.study,
        study_sha256=study.sha256(),
        fits={labels: one.sha256() for labels, one in fits.items()},
        findings=findings,
        made_by=code_version("stats", "protocol", "human"),
    )
    made.write(opened.folder.evaluation)
    return made


def _frozen(opened: OpenStudy) -> dict[Labels, FrozenFit]:
    """The frozen fits; each was made of this study's development prompts and of nothing else."""
    study, found = opened.study, dict[Labels, FrozenFit]()
    for labels in get_args(Labels):
        path = opened.folder.fit(labels)
        if not path.is_file():
            continue
        one = FrozenFit.read(path)
        if one.study_sha256 != study.sha256() or one.labels != labels:
            raise BadInput("this fit is not of this study", where=str(path), todo=FrozenFit.REMEDY)
        if (one.saw, one.holdout) != (study.development, study.holdout):
            raise BadInput("this fit was not made of the development prompts", where=str(path), todo=FrozenFit.REMEDY)
        made_of = (opened.rankings_digest("development"), study.components_sha256["development"])
        if (one.rankings_sha256, one.components_sha256) != made_of:
            raise BadInput("this fit was frozen on other rankings", where=str(path), todo=FrozenFit.REMEDY)
        found[labels] = one
    if not found:
        raise BadInput(
            "no weights are frozen: the holdout stays closed until they are",
            where=study.study,
            todo=f"c4s human fit {study.study}",
        )
    return found


def _open(opened: OpenStudy, fits: Mapping[Labels, FrozenFit]) -> None:
    """Write down that the holdout is opened; ``BadInput`` where it was opened with other fits or rankings."""
    path = opened.folder.opened
    record = HoldoutOpened(
        study_sha256=opened.study.sha256(),
        fits={labels: one.sha256() for labels, one in fits.items()},
        rankings_sha256={part: opened.rankings_digest(part) for part in BOTH},
    )
    if not path.is_file():
        record.write(path)
    elif HoldoutOpened.read(path) != record:
        raise BadInput("the holdout was opened with other fits or rankings than these", where=str(path))


def _findings(opened: OpenStudy, policies: Mapping[str, SubscoreWeights], told: Progress | None) -> Findings:
    study, candidates = opened.study, opened.candidates()
    held = opened.preferences("holdout")
    worths = log_worths(opened.orders("holdout"), len(study.holdout), candidates)
    developed = opened.preferences("development")
    table = np.stack([policy.hundredths() for policy in policies.values()])
    scores = {part: policy_scores(opened.scenes(part), table) for part in BOTH}
    rows: list[dict[str, Value]] = []
    long: list[dict[str, Value]] = []
    for number, name in enumerate(policies):
        dev, hold = (opened.by_prompt(scores[part][number]) for part in BOTH)
        by_prompt = {
            "dev_individual": with_scores(dev, developed),
            "holdout_individual": with_scores(hold, held),
            "holdout_consensus": with_scores(hold, consensus(worths)),
            "holdout_tau": tau_by_prompt(hold, worths),
            "holdout_rho": rho_by_prompt(hold, worths),
        }
        means = {key: macro_mean(values, study.seed) for key, values in by_prompt.items()}
        rows.append({"policy": name, **{key: known(mean.value) for key, mean in means.items()}})
        long += [measured_row({"policy": name, "measure": MEASURES[key]}, mean) for key, mean in means.items()]
        if told is not None:
            told("comparing policies", number + 1, len(policies))
    people = [
        measured_row({"prompts of": part}, macro_mean(between_annotators(preferences), study.seed))
        for part, preferences in (("all", opened.preferences(*BOTH)), ("development", developed), ("holdout", held))
    ]
    return Findings(
        tables=[
            Table(
                name="policies",
                title="Share of preferences that a policy agrees with",
                columns=[
                    Column(name="policy", title="policy"),
                    *(Column(name=key, title=title, decimals=DIGITS, marks="high") for key, title in MEASURES.items()),
                ],
                rows=rows,
            ),
            Table(
                name="intervals",
                title="The same with intervals of whole prompts",
                columns=[Column(name="policy", title="policy"), Column(name="measure", title="measure"), *MEASURED],
                rows=long,
            ),
            Table(
                name="people",
                title="Two annotators on one pair",
                columns=[Column(name="prompts of", title="prompts of"), *MEASURED],
                rows=people,
            ),
            _weights(policies),
            *diagnostics(opened),
        ],
        charts=[
            Chart(
                name="holdout",
                title="Agreement with people",
                kind="bars",
                table="intervals",
                x="value",
                y="measure",
                low="low",
                high="high",
                group="policy",
            )
        ],
        intervals=[intervals("holdout", len(study.holdout), study.seed)],
        notes=[
            f"{len(study.holdout)} holdout prompts, {len(held)} individual preferences, "
            f"{len(consensus(worths))} consensus pairs; ties of a score agree with nothing.",
            "This validates on prompts that nobody fitted to, of the same suite and configurations. Where the adopted "
            "weights were chosen with these prompts in sight, as in the published study, it is retrospective. Neither "
            "judgements nor measurements were fitted, and annotators saw four overview pictures, no measurement and "
            "no closer view.",
        ],
    )


def _weights(policies: Mapping[str, SubscoreWeights]) -> Table:
    blocks = {name: blocks_of(policy).plain() for name, policy in policies.items()}
    return Table(
        name="weights",
        title="Weights of the policies",
        columns=[
            Column(name="block", title="block"),
            Column(name="part", title="part"),
            *(Column(name=name, title=name, decimals=2) for name in policies),
        ],
        rows=[
            {"block": block, "part": part, **{name: blocks[name][block][part] for name in policies}}
            for block in WeightBlocks.model_fields
            for part in blocks["adopted"][block]
        ],
    )
