"""Weights fitted to the development prompts and frozen. The folder of the holdout is not opened here."""

from __future__ import annotations

from c4s.errors import BadInput
from c4s.human.study import OpenStudy
from c4s.records.human import FrozenFit, Labels, WeightBlocks
from c4s.records.version import code_version
from c4s.stats.human import ADOPTED, SEED, Objective, PairVotes, Progress, SubscoreWeights, consensus, fit, log_worths


def fit_study(opened: OpenStudy, labels: Labels, told: Progress | None = None) -> FrozenFit:
    """Fit the weights to one kind of label and freeze them in the study's folder.

    A fit that is frozen already is given again where it was made of the same rankings; the same command gives the same
    weights.

    Raises:
        BadInput: the holdout is open, a development prompt lacks a ranking, or a fit of other rankings is there.
    """
    study, path = opened.study, opened.folder.fit(labels)
    rankings = opened.rankings_digest("development")
    if path.is_file():
        frozen = FrozenFit.read(path)
        if (frozen.study_sha256, frozen.rankings_sha256) != (study.sha256(), rankings):
            raise BadInput("this fit was frozen on other rankings", where=str(path), todo=FrozenFit.REMEDY)
        return frozen
    if opened.is_opened():
        raise BadInput(
            "the holdout of this study is open: weights that are fitted now could have seen it", where=study.study
        )
    opened.complete("development")
    objective = Objective(
        opened.scenes("development"), votes_of(opened, labels), opened.candidates(), ADOPTED.hundredths()
    )
    found = fit(objective, SEED, told)
    made = FrozenFit(
        study=study.study,
        study_sha256=study.sha256(),
        labels=labels,
        saw=study.development,
        holdout=study.holdout,
        rankings_sha256=rankings,
        components_sha256=study.components_sha256["development"],
        weights=blocks_of(SubscoreWeights.of(found.hundredths)),
        agreement=found.standing.agreement,
        loss=found.standing.loss,
        distance=found.standing.distance,
        comparison_agreement=found.comparison.agreement,
        seed=SEED,
        looked_at=found.looked_at,
        passes=found.passes,
        made_by=code_version("stats", "protocol"),
    )
    made.write(path)
    return made


def votes_of(opened: OpenStudy, labels: Labels) -> PairVotes:
    """What the development prompts say of each pair: their annotators, or their consensus."""
    if labels == "individual":
        return opened.preferences("development").units()
    orders = opened.orders("development")
    worths = log_worths(orders, len(opened.study.prompts_of("development")), opened.candidates())
    return consensus(worths).units()


def blocks_of(weights: SubscoreWeights) -> WeightBlocks:
    """Weights as a record holds them."""
    return WeightBlocks.parse(
        {
            "families": dict(weights.families),
            "dimensions": dict(weights.dimensions),
            "leaves": dict(weights.leaves),
            "final": dict(weights.final),
        }
    )
