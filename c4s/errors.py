"""The one error model of c4s: whose fault a failure is, and what follows.

Every error that c4s raises on purpose is of one of three kinds:

* ``BadInput``: what the user gave cannot be used (a missing pack, a malformed task, a truncated snapshot).
  One line says what is wrong, where, and what to do. Exit code 2. Nothing is scored.
* ``MachineryFault``: c4s or something that it runs failed (an engine that died, a judge that does not answer,
  a full disk). Exit code 3. The trial stays pending: a fault of the machinery is never a score.
* ``AgentFault``: the agent under test failed (no submission, a budget overrun, a crashed client). It is an
  outcome, kept on record in the attempt, and never ends the run.

A run that a guard stopped before it was done (a deadline, its spending limit, its operator, a signal) is a pending run
like one with a fault, but nothing failed: the answer to whether it is done is no, exit code 1. Where what stopped it is
that its trials fail for one cause, it is exit code 3 (``c4s.run.guards``).

Whose fault something is depends on where it surfaces, and ``TABLE`` says it: a row a failure, a column a place.
``c4s.run.faults`` reads the table and is the only place that decides. The policy behind it:

* *Machinery* is what the agent cannot bring about. Pending, and repeated as often as the command is given.
* *Doubt* is a failure of an attempt that an agent may have brought about. Pending, recorded in the trial's
  ``faults.jsonl``, and counted: the attempt is repeated when the command is given again, ``MOST_REPEATS`` times at
  most. When the last repeat ends so too, the agent had acted (called a tool) in every one of them, and the machine does
  the same for the case's own start level, the attempt ends with the outcome ``repeats_spent``. A whole run that is
  killed records nothing, so it counts nothing.
* *Agent*: what an engine says or does after agent code ran in it is that code's doing. The attempt ends as
  ``agent_error``.
* *Scene* is a failure of a stage that reads one submission and trusted files. It is repeated once in a fresh worker,
  with a fresh engine. Where it fails again, the control does the same for the case's own start level. If the control
  fails too, it is machinery; else it is the verdict on the scene, with the row's reason code.

Functions raise; nothing catches an error only to go on as if nothing had happened. There are two boundaries:
the command line (``c4s.cli``) turns an error into one line and an exit code, and the program of a trial
(``c4s.run.trial``) turns one into a recorded outcome where the table says so. Everything else lets errors pass. An
error of the system about a place that was named (no such folder, not permitted) is bad input at the command line, any
other the machinery's; an exception that no policy names is a fault of c4s: exit code 3, and its traceback in a file.
"""

from __future__ import annotations

import errno
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Final, Literal

Whose = Literal["input", "machinery", "doubt", "agent", "scene"]
Place = Literal["attempt", "attempt_with_code", "scene", "elsewhere"]
"""An attempt in whose engine no agent code ran yet, one in whose engine it did, a stage that reads one scene and
trusted files (integrity, look, verify, an offline judge), and all else."""
ReasonCode = Literal["unloadable", "resource_limit", "crash", "cannot_be_exported", "cannot_be_drawn"]
"""Why a scene has no score, where it made a stage fail."""
MOST_REPEATS: Final = 3
"""Repeats of one attempt after a failure in doubt."""


@dataclass(frozen=True)
class FailureRow:
    """A failure by the name of its class or its error number, and whose fault it is in each place."""

    failure: str
    means: str
    attempt: Whose
    attempt_with_code: Whose
    scene: Whose
    elsewhere: Whose
    code: ReasonCode | None = None
    """The verdict's reason code where it is the scene's."""
    todo: str = "run the same command again"
    """What to do where it leaves a trial pending."""

    def whose(self, place: Place) -> Whose:
        """Whose fault it is there."""
        found: Whose = getattr(self, place)
        return found


_FREE = "make room on the disk, then run the same command again"
_RAISE = "raise the limit (`ulimit -n`) or run fewer slots, then run the same command again"
_MEMORY = "free memory or run fewer slots, then run the same command again"
_DISK = "see to the disk, then run the same command again"
_MEND = "the same command fails again: the trial's faults.jsonl holds the traceback; mend the code first"
TABLE: Final[tuple[FailureRow, ...]] = (
    FailureRow("ENOSPC", "the disk is full", "machinery", "machinery", "machinery", "machinery", todo=_FREE),
    FailureRow(
        "EDQUOT", "the user's disk quota is spent", "machinery", "machinery", "machinery", "machinery", todo=_FREE
    ),
    FailureRow("EIO", "the disk fails", "machinery", "machinery", "machinery", "machinery", todo=_DISK),
    FailureRow("EROFS", "the disk is read-only", "machinery", "machinery", "machinery", "machinery", todo=_DISK),
    FailureRow("ENFILE", "the machine has no file handle left", "machinery", "machinery", "machinery", "machinery"),
    FailureRow(
        "EMFILE", "a process of c4s has no descriptor left", "doubt", "doubt", "machinery", "machinery", todo=_RAISE
    ),
    FailureRow("ENOBUFS", "the machine has no socket buffer left", "doubt", "doubt", "machinery", "machinery"),
    FailureRow("ENOMEM", "the machine has no memory left", "doubt", "doubt", "machinery", "machinery", todo=_MEMORY),
    FailureRow("BadInput", "what the user gave cannot be used", "input", "input", "input", "input", todo=""),
    FailureRow(
        "SceneUnreadable", "a clean engine does not load, export or draw it", "input", "input", "scene", "input"
    ),
    FailureRow("AgentFault", "the agent failed", "agent", "agent", "agent", "agent", todo=""),
    FailureRow("MachineryFault", "c4s says that it failed itself", "machinery", "machinery", "machinery", "machinery"),
    FailureRow(
        "OverLimit", "a process over its time or memory", "doubt", "doubt", "scene", "machinery", "resource_limit"
    ),
    FailureRow(
        "EngineOverLimit", "an engine over its limits", "doubt", "agent", "scene", "machinery", "resource_limit"
    ),
    FailureRow("EngineDied", "an engine that ended", "doubt", "agent", "scene", "machinery", "crash"),
    FailureRow("BridgeFault", "an engine that is silent or gone", "doubt", "agent", "scene", "machinery", "crash"),
    FailureRow(
        "WrongAnswer", "an answer that is not what was asked for", "doubt", "agent", "scene", "machinery", "crash"
    ),
    FailureRow(
        "EngineCallError", "a function raised inside an engine", "doubt", "agent", "scene", "machinery", "crash"
    ),
    FailureRow("WorkerDied", "a worker process that ended", "doubt", "doubt", "scene", "machinery", "crash"),
    FailureRow(
        "MemoryError", "more memory asked for than there is", "doubt", "doubt", "scene", "machinery", "resource_limit"
    ),
    FailureRow("Unforeseen", "such a one, told", "doubt", "doubt", "machinery", "machinery", todo=_MEND),
    FailureRow("Exception", "what the code did not foresee", "doubt", "doubt", "machinery", "machinery", todo=_MEND),
)
"""The most special class of an error counts. An error number counts before its class, also where it is the cause."""
ROWS: Final = {row.failure: row for row in TABLE}

MOST_TOLD = 10_000
"""Characters of each part of an error: one that repeats what it was given is no longer than that."""

_MOST_NAMED = 12


class C4SError(Exception):
    """Base of all errors that c4s raises on purpose.

    Args:
        what: what is wrong, in a few words.
        where: the file, case, actor or option concerned.
        todo: what the reader can do about it.
    """

    exit_code = 3

    def __init__(self, what: str, *, where: str = "", todo: str = "") -> None:
        self.what, self.where, self.todo = (_short(text) for text in (what, where, todo))
        super().__init__(self.line())

    def line(self) -> str:
        """The error as one line: ``where: what (todo)``."""
        text = f"{self.where}: {self.what}" if self.where else self.what
        text = f"{text} ({self.todo})" if self.todo else text
        return " ".join(text.split())

    def __reduce__(self) -> tuple[Any, ...]:
        """Whole across a process border: class, text and fields, whatever its constructor takes."""
        return _again, (type(self), self.args, self.__dict__)


def _short(text: str) -> str:
    return text if len(text) <= MOST_TOLD else f"{text[: MOST_TOLD // 2]} ... {text[-MOST_TOLD // 2 :]}"


def _again(kind: type[C4SError], args: tuple[Any, ...], fields: dict[str, Any]) -> C4SError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(fields)
    return error


class BadInput(C4SError):
    """What the user gave cannot be used."""

    exit_code = 2


def unknown(what: str, given: str, known: Iterable[str], *, where: str = "", todo: str = "") -> BadInput:
    """The error for a name that is not among those that are known: the nearest one, then what there is.

    ``todo`` is what to do where nothing is known.
    """
    import difflib

    names = sorted(known)
    near = difflib.get_close_matches(given.lower(), names, n=1, cutoff=0.6)
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    listed = f"there is {', '.join(names[:_MOST_NAMED])}{more}" if names else ""
    hints = [f"did you mean {near[0]!r}?" if near else "", listed or todo, todo if listed else ""]
    return BadInput(f"unknown {what} {given!r}", where=where, todo="; ".join(hint for hint in hints if hint))


class MachineryFault(C4SError):
    """c4s, or a program that it runs, failed. Never a score."""

    exit_code = 3


class MachineShort(MachineryFault):
    """The machine is short of something, or its disk fails: ``name`` is the error number's, a row of the table."""

    def __init__(self, what: str, *, name: str, where: str = "", todo: str = "") -> None:
        self.name = name
        super().__init__(what, where=where, todo=todo)


class OverLimit(MachineryFault):
    """A process that c4s runs went over its time or its memory and was ended."""


class Unforeseen(MachineryFault):
    """Code of c4s raised what it did not foresee: the same work fails again."""


class AgentFault(C4SError):
    """The agent under test failed. An outcome, not a fault of the run."""

    exit_code = 1


def shortage(error: BaseException) -> MachineShort | None:
    """What the machine is short of, where that is this error or what caused it; None where it is not."""
    for cause in _causes(error):
        if isinstance(cause, MachineShort):
            return cause
        name = errno.errorcode.get(cause.errno or 0, "") if isinstance(cause, OSError) else ""
        if name in ROWS:
            where = str(cause.filename) if isinstance(cause, OSError) and cause.filename is not None else ""
            return MachineShort(ROWS[name].means, name=name, where=where, todo=ROWS[name].todo)
    return None


def _causes(error: BaseException | None) -> Iterator[BaseException]:
    """An error and what caused it. An error that is raised again from what it caused is its own cause: told once."""
    told = set()
    while error is not None and id(error) not in told:
        told.add(id(error))
        yield error
        error = error.__cause__


def row_of(error: BaseException) -> FailureRow:
    """The row of an error: of the error number behind it, else of its most special class."""
    short = shortage(error)
    names = [short.name] if short is not None else [kind.__name__ for kind in type(error).__mro__]
    return next((ROWS[name] for name in names if name in ROWS), ROWS["Exception"])
