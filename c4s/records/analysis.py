"""An answer to a study's question, with all that is needed to give it again: ``analyses/<name>-<id>/analysis.json``.

The rows that it was computed from lie beside it as Parquet, a file a source, and are compared with their digests
before they are read again.
"""

from __future__ import annotations

from typing import Any, ClassVar, Literal

from pydantic import Field

from c4s.files import digest
from c4s.records.base import Record, Sealed

Value = str | int | float | bool | None
ChartKind = Literal["bars", "dots", "heat", "lines", "scatter", "stacks"]


MEASURES = ("points", "USD", "seconds", "trials", "cases")
"""Units that people are told beside a title."""


class Column(Record):
    """A column of a table."""

    name: str
    title: str
    unit: str = ""
    """``score`` and ``share`` are in [0, 1], ``points`` are hundredths of a score; counts and words have none."""
    decimals: int | None = None
    """How many are shown; what is stored is not rounded."""
    marks: Literal["high", "low"] | None = None
    """Which end is best: the best and the second of the printed values are marked."""

    def headed(self) -> str:
        """The title, with the unit where that is one of measure; scores and shares are in [0, 1] everywhere."""
        told = self.unit in MEASURES and self.unit not in self.title
        return f"{self.title} ({self.unit})" if told else self.title


class Table(Record):
    """Rows under columns, in the order in which they are shown."""

    name: str
    title: str
    columns: list[Column]
    rows: list[dict[str, Value]]

    def column(self, name: str) -> list[Value]:
        """The values of a column."""
        return [row.get(name) for row in self.rows]


class Chart(Record):
    """A picture of a table: which columns stand for what."""

    name: str
    title: str
    kind: ChartKind
    table: str
    x: str = ""
    """Column of the horizontal axis; of bars and dots, the length. Not of heat maps."""
    y: str
    """Column of the vertical axis; of bars and dots, the names."""
    only: dict[str, str] = Field(default_factory=dict)
    """Which rows are drawn: those that have these values."""
    low: str | None = None
    high: str | None = None
    """Ends of whiskers."""
    group: str | None = None
    """Column that tells series apart."""
    series: list[str] = Field(default_factory=list)
    """Columns of the values, where each is a series of its own: of heat maps, stacks and lines."""
    label: str | None = None
    """Column with words at the marks."""
    reference: float | None = None
    """A line that means something: no difference, the goal."""
    diagonal: bool = False
    """Whether both axes have one scale, with the line where they are equal."""
    log_x: bool = False
    """Whether the horizontal axis is logarithmic: costs."""


class Intervals(Record):
    """How the intervals of an analysis were made."""

    method: str
    level: float
    draws: int
    seed: int
    unit: str
    """What was drawn."""
    clusters: dict[str, int]
    """How many of them, by domain."""
    honest: bool
    """Where not, there are too few clusters: no interval is given."""
    proviso: str


class StudySource(Record):
    """Rows that an analysis was computed from."""

    name: str
    sql: str
    rows: int
    rows_sha256: str
    """Of the canonical JSON of the columns' names and the rows in their order."""


class Findings(Record):
    """What a study computes from its sources: a pure function of them and of the options."""

    tables: list[Table]
    charts: list[Chart] = Field(default_factory=list)
    intervals: list[Intervals] = Field(default_factory=list)
    notes: list[str] = Field(default_factory=list)
    """What a reader has to know to read the numbers right."""


class StudyResult(Sealed):
    """Findings with where they come from."""

    REMEDY: ClassVar[str] = "run `c4s analyze` again"
    schema_version: Literal["c4s.analysis.v1"] = "c4s.analysis.v1"
    name: str
    title: str
    section: str
    """Where the paper asks the question; empty for one of our own."""
    scope: dict[str, str]
    """What all rows share: suite, build, policy, judge, engine."""
    options: dict[str, Any]
    sources: list[StudySource]
    findings: Findings
    made_by: str
    """Digest of the code that computes."""

    def identity(self) -> str:
        """16 hex digits of what decides the numbers: the study, its options, its rows, its code."""
        parts = [self.name, self.options, [source.rows_sha256 for source in self.sources], self.made_by]
        return digest(parts)[:16]
