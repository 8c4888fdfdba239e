"""What a study is: rows that it asks the warehouse for, and a pure function of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import pandas as pd
from pydantic import Field

from c4s.files import MOST_WHOLE
from c4s.records.analysis import Findings
from c4s.records.base import Record
from c4s.stats.bootstrap import DRAWS, LEVEL, SEED

Frames = Mapping[str, pd.DataFrame]
"""Rows by the name of their source."""


class StudyOptions(Record):
    """What may be asked of studies; each takes some of them (``StudyDefinition.takes``)."""

    agents: list[str] = Field(default_factory=list)
    """Configurations, all without; a comparison takes two."""
    draws: int = Field(default=DRAWS, ge=100, le=1_000_000)
    seed: int = Field(default=SEED, ge=0, le=MOST_WHOLE)
    level: float = Field(default=LEVEL, gt=0.5, lt=1)
    pool: list[str] = Field(default_factory=list)
    """Configurations by whose scores the public cases were selected."""
    holm: bool = False
    """Whether p-values are adjusted for their number."""


BOTH_PANELS = frozenset({"visibility"})
"""``across`` of a study that keeps public and private cases apart itself."""
RESAMPLING = frozenset({"draws", "seed", "level"})


@dataclass(frozen=True)
class StudyDefinition:
    """One question of the paper, or of ours.

    Each source is one ``SELECT`` over the warehouse's tables and views. It may read ``chosen`` too: the rows of the
    view ``case_scores`` (one a planned trial, pending ones too) of the suite's build, policy, judge and engine that
    were asked for.
    """

    name: str
    title: str
    section: str
    """Where the paper asks it: label and lines. Empty for a question of ours."""
    sources: Mapping[str, str]
    compute: Callable[[Frames, StudyOptions], Findings]
    takes: frozenset[str] = frozenset()
    """StudyOptions that it heeds; another one that is given is refused."""
    defaults: Mapping[str, object] = field(default_factory=dict)
    """Options that are other than everywhere, where nobody gives them: the seed of a study of the paper."""
    across: frozenset[str] = frozenset()
    """What ``chosen`` may differ in, such as judges that are compared; names of ``StudyScope``. Without the panel in it
    the cases are of one panel."""
