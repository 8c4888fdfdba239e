"""The weights of the policies that the site's results are scored under, from the policies themselves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from c4s.protocol.repair import PROFILES
from c4s.protocol.settings import SETTING_TITLES, SETTINGS
from c4s.records.policy import ScorePolicy
from c4s.score.policies import POLICIES


@dataclass(frozen=True)
class WeightTable:
    """Weights that sum to 1."""

    title: str
    rows: dict[str, float]


@dataclass(frozen=True)
class PolicyTold:
    """A policy as a page shows it."""

    policy: ScorePolicy
    tables: list[WeightTable]
    tolerances: str


def weight_tables(names: Iterable[str]) -> list[PolicyTold]:
    """The shipped policies among some names, each once."""
    return [_told(POLICIES[name]) for name in dict.fromkeys(names) if name in POLICIES]


def _told(policy: ScorePolicy) -> PolicyTold:
    limits = PROFILES[policy.repair_tolerances]
    told = f"{limits.position_cm:g} cm, {limits.rotation_deg:g} degrees and {limits.ratio:.1%} of scale or extent"
    return PolicyTold(policy, list(_tables(policy)), told)


def _tables(policy: ScorePolicy) -> Iterator[WeightTable]:
    by_weights: dict[tuple[tuple[str, float], ...], list[str]] = {}
    for setting in SETTINGS:
        by_weights.setdefault(tuple(policy.weights(setting).items()), []).append(SETTING_TITLES[setting])
    for weights, titles in by_weights.items():
        yield WeightTable(f"Case score: {' and '.join(titles)}", dict(weights))
    yield WeightTable("Detailed Alignment: requirement families", {str(k): v for k, v in policy.families.items()})
    yield WeightTable("Overview Alignment: dimensions", policy.overview)
    yield WeightTable("Physical Safety: leaves", policy.physics_leaves)
