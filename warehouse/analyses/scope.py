"""Which results are looked at together: one build of a suite, one policy, judge, engine and panel."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from c4s.errors import BadInput, unknown
from c4s.records.base import Record
from warehouse.database import rows

FIELDS = ("suite", "suite_digest", "policy", "judge", "judge_version", "engine", "visibility")


class StudyScope(Record):
    """What results share. A field that is None may differ."""

    suite: str
    suite_digest: str
    policy: str | None
    judge: str | None
    judge_version: str | None
    engine: str | None
    visibility: str | None
    """The panel: scores of public and private cases are never one mean."""

    def sql(self) -> str:
        """The scheduled trials of the scope with their scores, as a ``SELECT``."""
        told = self.told()
        return "SELECT * FROM case_scores WHERE " + " AND ".join(
            f"{name} = '{value.replace(chr(39), 2 * chr(39))}'" for name, value in told.items()
        )

    def told(self) -> dict[str, str]:
        """The fields that are fixed."""
        return {name: value for name, value in self.plain().items() if value is not None}


class WantedScope(Record):
    """What somebody asks for; what is None is chosen where there is one choice."""

    suite: str | None = None
    suite_digest: str | None = None
    """Or the start of it."""
    policy: str | None = None
    judge: str | None = None
    judge_version: str | None = None
    engine: str | None = None
    visibility: str | None = None


def choose(warehouse: Path, wanted: WantedScope, across: Collection[str] = ()) -> StudyScope:
    """The one scope that is wanted: of its suite the latest build, unless another is named.

    ``BadInput`` where nothing is there, where nothing is as wanted, and where several are: it names them.
    """
    names = ", ".join(FIELDS)
    found = rows(warehouse, f"SELECT DISTINCT latest, {names} FROM trials ORDER BY {names}")
    if not found:
        raise BadInput("the warehouse holds no trial", where=str(warehouse), todo="run `c4s run SUITE` first")
    for name, value in wanted.plain().items():
        if value is not None:
            there = sorted({row[name] for row in found})
            found = [row for row in found if _is(name, value, row[name])]
            if not found:
                raise unknown(_OPTIONS[name].replace("-", " "), value, there)
    if wanted.suite_digest is None:
        found = [row for row in found if row["latest"]] or found
    fixed = [name for name in FIELDS if name not in across or getattr(wanted, name) is not None]
    for name in fixed:
        if len(choices := sorted({row[name] for row in found})) > 1:
            raise BadInput(
                f"there are results of {len(choices)} {_PLURALS[name]}: {', '.join(choices)}",
                todo=f"say which: --{_OPTIONS[name]} {choices[-1]}",
            )
    return StudyScope.parse({name: found[0][name] if name in fixed else None for name in FIELDS})


def _is(name: str, value: str, found: str) -> bool:
    return found.startswith(value) if name == "suite_digest" else found == value


_PLURALS = {
    "suite": "suites",
    "suite_digest": "builds of the suite",
    "policy": "policies",
    "judge": "judges",
    "judge_version": "versions of the judge",
    "engine": "engines",
    "visibility": "panels",
}
_OPTIONS = {name: name.replace("_", "-") for name in FIELDS} | {"suite_digest": "build", "visibility": "panel"}
