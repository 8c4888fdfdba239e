"""Rows and columns that the tables of a human study share."""

from __future__ import annotations

import math
from typing import Final

from c4s.records.analysis import Column, Intervals, Value
from c4s.records.human import Part
from c4s.stats.bootstrap import LEAST_CLUSTERS, LEVEL
from c4s.stats.human import ALPHA_DRAWS, DRAWS, MacroMean

BOTH: Final[tuple[Part, Part]] = ("development", "holdout")
DIGITS: Final = 4
"""Decimals that are shown."""
MEASURED: Final = [
    Column(name="value", title="value", decimals=DIGITS),
    Column(name="low", title="low", decimals=DIGITS),
    Column(name="high", title="high", decimals=DIGITS),
    Column(name="prompts", title="prompts"),
]


def measured_row(names: dict[str, Value], value: MacroMean) -> dict[str, Value]:
    """A number with its interval under some names."""
    numbers = {"value": value.value, "low": value.low, "high": value.high}
    return {**names, **{key: known(number) for key, number in numbers.items()}, "prompts": value.prompts}


def known(number: float) -> float | None:
    """A number as a table holds it: None where there is none."""
    return None if math.isnan(number) else number


def intervals(part: str, prompts: int, seed: int) -> Intervals:
    """How the intervals of some prompts are made, and whether they are honest."""
    honest = prompts >= LEAST_CLUSTERS
    proviso = "Prompts are drawn, not preferences: candidates of a prompt are shared by its pairs."
    if not honest:
        proviso = (
            f"An interval from few prompts (here {prompts}) does not hold the truth as often as it says; it is told "
            "because the published study tells one of four."
        )
    return Intervals(
        method=f"whole-prompt bootstrap, percentile; Krippendorff's alpha with {ALPHA_DRAWS:,} draws",
        level=LEVEL,
        draws=DRAWS,
        seed=seed,
        unit="prompt",
        clusters={part: prompts},
        honest=honest,
        proviso=proviso,
    )
