"""Public and private cases apart: each set is a table of its own, with the configurations that are complete on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd

from c4s.errors import BadInput
from c4s.protocol.rules import MODEL_WEIGHTS
from c4s.protocol.settings import SETTING_TITLES
from c4s.records.analysis import Table
from c4s.stats.bootstrap import Floats
from warehouse.analyses.cases import (
    CONSTRUCTIONS,
    REPAIRS,
    VISIBILITIES,
    CaseTable,
    NoneComplete,
    case_table,
    known_agents,
)
from warehouse.analyses.study import StudyOptions

SETS = VISIBILITIES
TITLES: dict[str, str] = {str(name): title for name, title in SETTING_TITLES.items()}
"""Of settings, as rows name them."""


@dataclass(frozen=True)
class SetPanel:
    """The cases of one set."""

    name: str
    cases: CaseTable


def panels(chosen: pd.DataFrame, options: StudyOptions) -> list[SetPanel]:
    """A panel a set that has cases and a complete configuration, the public one first.

    ``BadInput`` for an unknown configuration, and where no set has a complete one.
    """
    known_agents(chosen, options)
    found, refused = [], []
    for name in SETS:
        rows = chosen[chosen["visibility"] == name]
        there = set(rows["configuration"])
        wanted = [agent for agent in options.agents if agent in there]
        if len(rows) and (wanted or not options.agents):
            try:
                cases = case_table(rows, options.model_copy(update={"agents": wanted}))
            except NoneComplete as error:
                refused.append(error)
            else:
                found.append(SetPanel(name, cases))
    if not found:
        if refused:
            raise refused[0]
        case_table(chosen, options)
    return found


def apart_of(found: list[SetPanel]) -> list[Table]:
    """The configurations that each panel leaves out."""
    return [
        panel.cases.apart.model_copy(
            update={"name": f"apart_{panel.name}", "title": f"{panel.cases.apart.title} ({panel.name} set)"}
        )
        for panel in found
        if panel.cases.apart.rows
    ]


@dataclass(frozen=True)
class CoverageGate:
    """Which configurations are complete on each set, for studies of rows that are no scores."""

    complete: frozenset[tuple[str, str]]
    """Set and configuration."""
    apart: list[Table]
    """The others, with their coverage."""

    def passed(self, rows: pd.DataFrame) -> pd.DataFrame:
        """Those of some rows, with ``visibility`` and ``configuration``, that are of complete configurations."""
        pairs = zip(rows["visibility"], rows["configuration"], strict=True)
        return rows[np.array([pair in self.complete for pair in pairs], dtype=bool)].reset_index(drop=True)


def coverage_gate(chosen: pd.DataFrame, options: StudyOptions, settings: Sequence[str]) -> CoverageGate:
    """The gate over the cases of some settings; refuses as ``panels`` does, and where the suite has no such case."""
    own = chosen[chosen["setting"].isin(settings)]
    if own.empty:
        raise BadInput("this suite has no case of that kind", todo="c4s analyze main-results")
    found = panels(own, options)
    complete = frozenset((panel.name, agent) for panel in found for agent in panel.cases.agents)
    return CoverageGate(complete, apart_of(found))


def ranked_places(table: CaseTable) -> list[int]:
    """Places of the configurations that are ranked. ``BadInput`` where none is complete."""
    places = [place for place, ranked in enumerate(table.ranked) if ranked]
    if not places:
        raise BadInput(
            "only configurations that validate the evaluator are complete, and those are not ranked",
            todo="c4s analyze main-results",
        )
    return places


def set_scores(settings: Sequence[str], values: Floats) -> dict[str, Floats]:
    """Each configuration's mean over the cases of every setting, of each side, and of both sides as one.

    Args:
        settings: of each case.
        values: shape (cases, configurations).

    Returns:
        By setting, and by ``t2s``, ``i2s`` and ``model`` where all their settings have cases.
    """
    of = np.array(settings)
    found = {str(setting): values[of == setting].mean(axis=0) for setting in dict.fromkeys(settings)}
    for side, wanted in (("t2s", CONSTRUCTIONS), ("i2s", REPAIRS)):
        if found.keys() >= set(wanted):
            found[side] = values[np.isin(of, wanted)].mean(axis=0)
    if MODEL_WEIGHTS.keys() <= found.keys():
        found["model"] = np.asarray(sum(weight * found[side] for side, weight in MODEL_WEIGHTS.items()))
    return found
