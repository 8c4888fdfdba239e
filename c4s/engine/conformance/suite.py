"""All checks, and a run of them over one kind of engine."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from c4s.engine.base import backend
from c4s.engine.conformance import bridge, pictures, questions, saving, scene
from c4s.engine.conformance.check import Check, Failed
from c4s.engine.conformance.departures import DEPARTURES
from c4s.engine.conformance.ground import Ground
from c4s.errors import C4SError, unknown

Status = Literal["passed", "failed", "departs", "recorded"]


@dataclass(frozen=True)
class Result:
    """What came of a check."""

    name: str
    group: str
    says: str
    status: Status
    detail: str = ""
    """What the engine did instead, for a known departure also the reason; of a question what it answered."""


@dataclass(frozen=True)
class Report:
    """What came of the checks of one engine."""

    engine: str
    version: str
    sandbox: str
    checks: list[Result]

    @property
    def failed(self) -> int:
        """How many failed."""
        return sum(result.status == "failed" for result in self.checks)


def all_checks() -> list[Check]:
    """Every check, and the open questions, in the order in which they run."""
    return [*bridge.CHECKS, *scene.CHECKS, *saving.CHECKS, *pictures.CHECKS, *questions.QUESTIONS]


def run(kind: str, only: Sequence[str] = (), progress: Callable[[Result], None] = lambda result: None) -> Report:
    """Run the checks (those named in ``only``, or all) on an engine of a kind.

    Raises:
        BadInput: there is no such kind or check.
        C4SError: no engine of the kind can be opened at all.
    """
    backend(kind)
    chosen = [check for check in all_checks() if not only or check.name in only]
    known = [check.name for check in all_checks()]
    for name in only:
        if name not in known:
            raise unknown("check", name, known, todo="leave --only out to run all of them")
    results = []
    with tempfile.TemporaryDirectory(prefix="c4s-conformance-") as folder:
        ground = Ground(kind, Path(folder))
        try:
            version, sandbox = ground.engine.version, ground.engine.sandbox  # what cannot be opened is no failed check
            for check in chosen:
                results.append(_result(check, ground))
                progress(results[-1])
        finally:
            ground.close()
    return Report(kind, version, sandbox, results)


def _result(check: Check, ground: Ground) -> Result:
    known = DEPARTURES.get(ground.kind, {}).get(check.name)
    try:
        answer, fault = check.run(ground), ""
    except Failed as failed:
        answer, fault = None, str(failed)
    except C4SError as error:
        answer, fault = None, error.line()
    if answer is not None:
        return Result(check.name, check.group, check.says, "recorded", answer)
    if known is not None and fault:
        return Result(check.name, check.group, check.says, "departs", f"{known} ({fault})")
    if known is not None:
        fault = "this is said to be a departure of the engine, and is none"
    return Result(check.name, check.group, check.says, "failed" if fault else "passed", fault)
