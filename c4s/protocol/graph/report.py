"""What the validator of requirement bundles says."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

from c4s.errors import BadInput

Severity: TypeAlias = Literal["error", "warning"]


@dataclass(frozen=True)
class GraphFinding:
    """One thing that is wrong with a bundle."""

    rule: str
    """Id of the rule, as ``docs/requirements.md`` lists them."""
    severity: Severity
    place: str
    """The node, edge or row concerned."""
    message: str


@dataclass(frozen=True)
class WordCoverage:
    """How much of a prompt its requirements speak of."""

    terms: int = 0
    """Content words of the prompt."""
    covered: int = 0
    uncovered: tuple[str, ...] = ()
    """The others, in order."""

    @property
    def ratio(self) -> float:
        """Share of the content words that are covered; 1 for a prompt without any."""
        return self.covered / self.terms if self.terms else 1.0


@dataclass(frozen=True)
class GraphReport:
    """All that was found in a bundle."""

    findings: tuple[GraphFinding, ...] = ()
    coverage: WordCoverage = field(default_factory=WordCoverage)
    counts: dict[str, int] = field(default_factory=dict)
    """Entities, predicates and scored requirements."""

    @property
    def errors(self) -> list[GraphFinding]:
        """What makes the bundle unusable."""
        return [finding for finding in self.findings if finding.severity == "error"]

    @property
    def warnings(self) -> list[GraphFinding]:
        """What its author should know."""
        return [finding for finding in self.findings if finding.severity == "warning"]

    def refuse(self, *, where: str = "", todo: str = "see `c4s suite requirements check`") -> None:
        """``BadInput`` in one line where there is an error, with what to do."""
        if not self.errors:
            return
        first, more = self.errors[0], len(self.errors) - 1
        told = f" (and {more} more error{'s' if more > 1 else ''})" if more else ""
        raise BadInput(
            f"this requirement bundle cannot be used: {first.place}: {first.message} [{first.rule}]{told}",
            where=where,
            todo=todo,
        )

    def plain(self) -> dict[str, Any]:
        """As plain JSON data."""
        return {
            "counts": self.counts,
            "coverage": {
                "content_term_count": self.coverage.terms,
                "covered_content_term_count": self.coverage.covered,
                "coverage_ratio": round(self.coverage.ratio, 4),
                "uncovered": list(self.coverage.uncovered),
            },
            "errors": [_plain(finding) for finding in self.errors],
            "warnings": [_plain(finding) for finding in self.warnings],
        }


def _plain(finding: GraphFinding) -> dict[str, str]:
    return {"rule": finding.rule, "place": finding.place, "message": finding.message}


MOST_FINDINGS = 200
"""A broken bundle of ten thousand nodes is not told about each."""


def gathered(findings: Iterable[GraphFinding]) -> tuple[GraphFinding, ...]:
    """At most ``MOST_FINDINGS`` of each severity, errors first."""
    kept: dict[Severity, list[GraphFinding]] = {"error": [], "warning": []}
    for finding in findings:
        if len(kept[finding.severity]) < MOST_FINDINGS:
            kept[finding.severity].append(finding)
    return (*kept["error"], *kept["warning"])
