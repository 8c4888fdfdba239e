"""Comparison renders: rows of pictures from the same cameras, all of them brightened alike."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean
from typing import Final

from reports.case.runs import CaseRun
from reports.frame import SitePicture

Pictures = Mapping[tuple[str, str], Sequence[SitePicture]]
"""By trial and role; those of the case have no trial."""
STEPS: Final = (100, 125, 150, 200)
"""Per cent of brightness that can be chosen."""
WANTED: Final = 0.42
"""Mean grey value that dark renders are lifted to."""


@dataclass(frozen=True)
class RenderRow:
    """Pictures of one scene, by column."""

    label: str
    run: CaseRun | None
    """Null for the start and the truth."""
    pictures: Mapping[str, SitePicture]


@dataclass(frozen=True)
class Renders:
    """All rows."""

    views: Sequence[str]
    """Columns: names of views."""
    rows: Sequence[RenderRow]
    brightness: float | None
    """Mean grey value of the first complete row, which the step is chosen by."""
    step: int
    """Per cent that every row is brightened to."""
    steps: Sequence[int] = STEPS


def renders_of(pictures: Pictures, runs: Sequence[CaseRun], *, construction: bool) -> Renders:
    """Start and truth, then each run in its order; views that several rows have are columns."""
    start, truth = (_named(pictures.get(("", role), ())) for role in ("start", "truth"))
    for run in runs:
        for picture in pictures.get((run.trial["trial_id"], "target_truth"), ()):
            truth.setdefault(picture.view, picture)
    label = "The scene that the prompt describes" if construction else "Truth"
    rows = [RenderRow("Start", None, start)] if start else []
    rows += [RenderRow(label, None, truth)] if truth else []
    rows += [
        RenderRow(
            run.configuration + (f" · repeat {run.trial['repeat']}" if run.trial["repeat"] > 1 else ""), run, found
        )
        for run in runs
        if (found := _named([*_of(pictures, run, "submission"), *_of(pictures, run, "target")]))
    ]
    views = sorted({view for row in rows for view in row.pictures}, key=lambda view: (view.startswith("target"), view))
    told = [one.brightness for one in (truth or (rows[0].pictures if rows else {})).values() if one.brightness]
    mean = fmean(told) if told else None
    wanted = 100.0 if mean is None else 100 * max(1.0, WANTED / mean)
    return Renders(views, rows, mean, min(STEPS, key=lambda step: abs(step - wanted)))


def _of(pictures: Pictures, run: CaseRun, role: str) -> Sequence[SitePicture]:
    return pictures.get((run.trial["trial_id"], role), ())


def _named(pictures: Sequence[SitePicture]) -> dict[str, SitePicture]:
    return {picture.view: picture for picture in pictures}
