"""Rates over trials, with intervals by source scenes: all trials of a scene are drawn together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
import pandas as pd

from c4s.records.analysis import Column, Intervals, Value
from c4s.stats.bootstrap import Design, Floats, percentile_interval, pooled_rate
from warehouse.analyses.cases import intervals_of, number
from warehouse.analyses.study import StudyOptions

DIAGNOSTICS_SEED: Final = 20_260_925
"""The paper's seed of its selective-repair and spatial diagnostics."""


@dataclass(frozen=True)
class TrialRates:
    """Rows of trials, or of what is in them, with the draws of their source scenes."""

    design: Design
    counts: Floats
    intervals: Intervals
    level: float

    @classmethod
    def of(cls, rows: pd.DataFrame, options: StudyOptions) -> TrialRates:
        """Of at least one row with ``scene_id`` and ``setting``."""
        design = Design.of(rows["scene_id"].tolist(), rows["setting"].tolist())
        made = intervals_of(design, options)
        drawn = design.draw(options.draws, options.seed) if made.honest else design.observed()
        return cls(design, drawn, made, options.level)

    def rate(self, hits: object, of: object) -> dict[str, Value]:
        """``count``, ``of``, ``share`` with its ends where they are honest."""
        base = np.asarray(of, dtype=bool)
        found = np.asarray(hits, dtype=bool) & base
        observed = float(pooled_rate(self.design, self.design.observed(), found, base)[0, 0])
        row: dict[str, Value] = {"count": int(found.sum()), "of": int(base.sum()), "share": number(observed)}
        if self.intervals.honest and base.any():
            low, high = percentile_interval(pooled_rate(self.design, self.counts, found, base), self.level)
            row |= {"share_low": number(low[0]), "share_high": number(high[0])}
        return row

    def columns(self, count: str, of: str, share: str) -> list[Column]:
        """The columns of such rows."""
        ends = (("share_low", f"{share} low"), ("share_high", f"{share} high")) if self.intervals.honest else ()
        return [
            Column(name="count", title=count),
            Column(name="of", title=of),
            Column(name="share", title=share, unit="share", decimals=3),
            *(Column(name=name, title=title, unit="share", decimals=3) for name, title in ends),
        ]
