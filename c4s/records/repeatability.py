"""How far a judge's scores repeat: what a study of repeats did and found.

``repeatability/<study>/repeatability.json`` of a run. The scores come from the files beside it, a
``judgements`` record a scene and repeat; the trials' own records are as they were.
"""

from __future__ import annotations

from typing import Any, ClassVar, Final, Literal

from pydantic import Field

from c4s.records.base import Record, Sealed
from c4s.records.judgement import JudgeUsage, Serving

COHORT: Final = (
    "a purposive subset: the configurations and cases that were asked for, no random sample of the benchmark; what is "
    "said of them holds for them"
)


class RepeatedScene(Record):
    """One generated scene with its Detailed Alignment in each repeat."""

    configuration: str
    case_id: str
    trial_repeat: int
    """Which generated scene of the case, where a run makes several."""
    judgements_sha256: str | None
    """Digest of the judgements that were repeated; null where no attempt left a valid scene, which is worth 0."""
    requests: int
    """Requests of its schedule, which every repeat makes."""
    scores: list[float]
    fallbacks: list[int]
    """Claims of each repeat that are unknown because an answer broke its contract twice."""
    asked_again: list[int]
    """Requests of each repeat beside the schedule, after an answer that broke its contract."""


class RepeatedConfiguration(Record):
    """A configuration's means over its scenes, a number a repeat."""

    configuration: str
    rank: int
    """By the mean over all repeats, from 1."""
    means: list[float]
    mean: float
    sd: float
    """Sample standard deviation of ``means``."""
    deviations: list[float]
    """``means`` less ``mean``."""


class RepeatAgreement(Record):
    """How two repeats order the configurations."""

    repeats: tuple[int, int]
    tau_b: float | None
    """Kendall's tau-b over the configurations' means; null where it has no value (one configuration, all equal)."""


class RankOrder(Record):
    """Which ranks every repeat tells alike."""

    leading: int
    """Ranks from the first on that no repeat disputes."""
    kept: list[int]
    """All ranks that no repeat disputes."""
    bands: list[tuple[int, int]]
    """First and last rank of the bands to which reversals are confined."""
    reversals: int
    """Pairs of configurations that one repeat orders so and another the other way."""


class ServedRepeat(Record):
    """Who answered in one repeat, over all scenes. Replicas and requests at once may differ from scene to scene."""

    replicas: tuple[int, int]
    """Fewest and most."""
    parallel: tuple[int, int]
    models: list[str]
    fingerprints: list[str]

    @classmethod
    def of(cls, served: list[Serving]) -> ServedRepeat:
        """Of the scenes of a repeat, at least one."""
        replicas, parallel = [one.replicas for one in served], [one.parallel for one in served]
        return cls(
            replicas=(min(replicas), max(replicas)),
            parallel=(min(parallel), max(parallel)),
            models=sorted({name for one in served for name in one.models}),
            fingerprints=sorted({name for one in served for name in one.fingerprints}),
        )


class Repeatability(Sealed):
    """A study of repeats."""

    REMEDY: ClassVar[str] = "run the same `c4s judge repeat` again: it is made anew from the repeats"
    schema_version: Literal["c4s.repeatability.v1"] = "c4s.repeatability.v1"
    study: str
    """12 hex digits, by content: the judge and the judgements that are repeated."""
    run_id: str
    suite_id: str
    suite_digest: str
    judge: str
    judge_version: str
    cohort: str = COHORT
    repeats: int = Field(ge=2)
    family_weights: dict[str, float]
    """The adopted weights, the same in every repeat whatever the run's policy."""
    evaluations: int
    """Scenes times repeats, all of them completed."""
    requests_per_repeat: int
    """Logical requests of the schedule, without transport retries and what was asked anew after a broken answer."""
    asked_again: int
    fallbacks: int
    configurations: list[RepeatedConfiguration]
    """The best first."""
    agreements: list[RepeatAgreement]
    ranks: RankOrder
    scenes: list[RepeatedScene]
    served: list[ServedRepeat]
    """One a repeat."""
    usage: list[JudgeUsage]
    """One a repeat."""

    def summary(self) -> dict[str, Any]:
        """The findings without the scenes, as plain data."""
        return {name: value for name, value in self.plain().items() if name != "scenes"}
