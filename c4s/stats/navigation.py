"""Means of embodied utility over scenes of which some are withheld (paper, "Withholding and aggregation").

A scene's utility is the share of things that can be approached times the share of walks that arrive. One that could
not be measured is withheld: NaN here, which is never a measured zero; only the conservative mean lets it count 0.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np

from c4s.stats.bootstrap import Floats
from c4s.stats.orders import pearson, spearman


@dataclass(frozen=True)
class UtilityMean:
    """A configuration's utility over its records of one cohort."""

    records: int
    zeros: int
    """Measured, with the result 0."""
    withheld: int
    conservative: float
    """Mean over all records, the withheld at 0."""
    standard_error: float | None
    """Of the conservative mean, between scenes; None for one record."""
    measured: float | None
    """Mean over what was measured; None where nothing was."""

    @property
    def coverage(self) -> float:
        """Share of the records that were measured."""
        return (self.records - self.withheld) / self.records


@dataclass(frozen=True)
class RoomMeans:
    """Utility with rooms as units: edits of one room share its geometry."""

    rooms: int
    measured: int
    """Rooms with a measured edit."""
    mean: float | None
    median: float | None


@dataclass(frozen=True)
class PairedChange:
    """Mean difference over the same scenes with its standard error."""

    pairs: int
    mean: float
    standard_error: float | None


@dataclass(frozen=True)
class Alignment:
    """How configurations' mean utility goes with another score of theirs."""

    configurations: int
    pearson: float | None
    spearman: float | None


def utility(approachable: float, arrived: int, walks: int) -> float:
    """A scene's utility: shares of things that can be approached and of walks that arrived. ``ValueError``: no walk."""
    if walks < 1:
        raise ValueError("without a walk the utility is withheld")
    return approachable * (arrived / walks)


def utility_mean(values: Floats) -> UtilityMean:
    """Over a configuration's records; shape (records,), NaN where withheld, at least one record."""
    if not len(values):
        raise ValueError("at least one record is expected")
    known = values[~np.isnan(values)]
    counted = np.nan_to_num(values)
    return UtilityMean(
        records=len(values),
        zeros=int((known == 0).sum()),
        withheld=len(values) - len(known),
        conservative=float(counted.mean()),
        standard_error=_standard_error(counted),
        measured=float(known.mean()) if len(known) else None,
    )


def room_means(values: Floats, rooms: Sequence[Hashable]) -> RoomMeans:
    """Mean and median over the rooms' own means; a room without a measured edit has none.

    Args:
        values: of each edit, NaN where withheld.
        rooms: of each edit.
    """
    names = list(dict.fromkeys(rooms))
    own = {name: np.array([value for value, room in zip(values, rooms, strict=True) if room == name]) for name in names}
    means = [float(np.nanmean(edits)) for edits in own.values() if not np.isnan(edits).all()]
    return RoomMeans(
        rooms=len(names),
        measured=len(means),
        mean=float(np.mean(means)) if means else None,
        median=float(np.median(means)) if means else None,
    )


def paired_change(after: Floats, before: Floats) -> PairedChange:
    """What changed over the same scenes, the withheld at 0 on both sides; shape (scenes,), at least one."""
    change = np.nan_to_num(after) - np.nan_to_num(before)
    return PairedChange(pairs=len(change), mean=float(change.mean()), standard_error=_standard_error(change))


def alignment(utilities: Floats, scores: Floats) -> Alignment:
    """Correlations over configurations, of which each has a mean utility and a score."""
    return Alignment(len(utilities), pearson(utilities, scores), spearman(utilities, scores))


def _standard_error(values: Floats) -> float | None:
    return float(values.std(ddof=1) / np.sqrt(len(values))) if len(values) > 1 else None
