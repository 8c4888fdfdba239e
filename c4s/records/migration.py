"""Records of earlier formats, brought to today's as they are read. No file is written anew.

A format is named ``c4s.<what>.v<number>``. The number rises when an older c4s could no longer read what is written, or
would read it wrong; a field that has a default does not raise it. ``STEPS`` holds one step a number, so a record of any
earlier number goes through all the steps that follow. What is newer than this c4s knows is refused.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

from c4s.errors import BadInput
from c4s.files import digest_file, read_json
from c4s.records.folder import TrialFolder

Plain = dict[str, Any]
Step = Callable[[Plain, str], Plain]
"""From a record as plain data, and where it lies, to one of the next number; the one that is given stays as it is."""

_NUMBERED: Final = re.compile(r"(?P<series>c4s\.[a-z-]+)\.v(?P<number>[1-9][0-9]{0,5})")
_FLAT_NUMBERS: Final = (
    "detailed",
    "known_coverage",
    "overview",
    "physics",
    "repair_precision",
    "repair_recall",
    "repair_f1",
)
"""What a score of 0.1.0 is made of, as fields of its own."""


def is_unsealed(value: Plain) -> bool:
    """Whether a record is one of those that c4s wrote before records held their own digests."""
    schema = value.get("schema_version")
    if schema in ("c4s.plan.v1", "c4s.suite.v1"):
        return True
    return schema in _SINCE_SEALS and _SINCE_SEALS[schema] not in value


def brought_up(value: Any, known: str, *, what: str, where: str) -> Any:
    """Plain data of a record in the format that is known; data that names no earlier format is given back.

    Args:
        value: what was read.
        known: the format that this c4s writes.
        what: what such a record is called.
        where: the file that it was read from.
    """
    if not isinstance(value, dict):
        return value
    told, mine = _numbered(value.get("schema_version")), _numbered(known)
    if told is None or mine is None or told[0] != mine[0]:
        return value
    if told[1] > mine[1]:
        raise BadInput(
            f"this {what} is of format {value['schema_version']}, and the newest that this c4s reads is {known}",
            where=where,
            todo="read it with the c4s that wrote it, or a newer one",
        )
    for number in range(told[1], mine[1]):
        step = STEPS.get(f"{told[0]}.v{number}")
        if step is None:
            raise BadInput(
                f"this {what} is of format {value['schema_version']}, which this c4s no longer reads",
                where=where,
                todo=f"make it anew: {known} is written today",
            )
        value = step(value, where) | {"schema_version": f"{told[0]}.v{number + 1}"}
    shape = EARLY.get(known)
    return shape(value, where) if shape is not None and is_unsealed(value) else value


def _numbered(schema: object) -> tuple[str, int] | None:
    found = _NUMBERED.fullmatch(schema) if isinstance(schema, str) else None
    return (found["series"], int(found["number"])) if found else None


def _named_by_id(value: Plain, where: str) -> Plain:
    """Plans and suites: a case was called the same everywhere."""
    cases = value.get("cases")
    if not isinstance(cases, list):
        return value
    named = [
        {**case, "alias": case.get("alias", case.get("case_id"))} if isinstance(case, dict) else case for case in cases
    ]
    return {**value, "cases": named}


def _agent_case(value: Plain, where: str) -> Plain:
    """The agent's side of a case told its id and its title."""
    kept = {name: part for name, part in value.items() if name not in ("case_id", "title")}
    return {**kept, "alias": value.get("case_id")}


def _withheld_case(value: Plain, where: str) -> Plain:
    """The title lay on the agent's side."""
    case_id = value.get("case_id")
    told = {**value, "alias": case_id}
    beside = Path(where).parents[2] / "agent" / str(case_id) / "case.json" if len(Path(where).parents) > 2 else None
    if beside is None or not beside.is_file():
        return told
    agent = read_json(beside, what="agent case")
    return {**told, "title": str(agent.get("title", ""))} if isinstance(agent, dict) else told


def _score(value: Plain, where: str) -> Plain:
    """A score told its numbers as fields, and not from which verdicts it was made: those that lie beside it."""
    kept = {name: part for name, part in value.items() if name not in _FLAT_NUMBERS}
    components = {name: value[name] for name in _FLAT_NUMBERS if value.get(name) is not None}
    beside = TrialFolder(Path(where).parent).verdicts if where else {}
    return {**kept, "components": components, "verdicts": {name: digest_file(path) for name, path in beside.items()}}


STEPS: Final[Mapping[str, Step]] = {
    "c4s.plan.v1": _named_by_id,
    "c4s.suite.v1": _named_by_id,
    "c4s.case.v1": _agent_case,
    "c4s.withheld.v1": _withheld_case,
}
"""The step that leads on from each earlier format."""
_SINCE_SEALS: Final[Mapping[object, str]] = {
    "c4s.attempt.v1": "client",
    "c4s.score.v1": "components",
    "c4s.verdict.v1": "made_by",
}
"""Formats whose number stayed when records came to hold their digests: a field that every record since then has."""
EARLY: Final[Mapping[str, Step]] = {"c4s.score.v1": _score}
"""What the records of that time need beside."""
