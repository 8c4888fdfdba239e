"""The one error model of c4s.

Every failure is one of three kinds, and the kind decides who acts and what the exit code is:

* ``BadInput``: what the user gave cannot be used (a missing pack, a malformed task, a truncated snapshot).
  One line says what is wrong, where, and what to do. Exit code 2. Nothing is scored.
* ``MachineryFault``: c4s or something that it runs failed (an engine that died, a judge that does not answer,
  a full disk). Exit code 3. The trial stays pending: a fault of the machinery is never a score.
* ``AgentFault``: the agent under test failed (no submission, a budget overrun, a crashed client). It is an
  outcome, kept on record in the attempt, and never ends the run.

Functions raise; nothing catches an error only to go on as if nothing had happened. There are two boundaries:
the command line (``c4s.cli``) turns an error into one line and an exit code, and the attempt and verify stages
turn an ``AgentFault`` or a ``MachineryFault`` into a recorded status. Everything else lets errors pass.
"""

from __future__ import annotations

from typing import Any


class C4SError(Exception):
    """Base of all errors that c4s raises on purpose.

    Args:
        what: what is wrong, in a few words.
        where: the file, case, actor or option concerned.
        todo: what the reader can do about it.
    """

    exit_code = 3

    def __init__(self, what: str, *, where: str = "", todo: str = "") -> None:
        self.what, self.where, self.todo = what, where, todo
        super().__init__(self.line())

    def line(self) -> str:
        """The error as one line: ``where: what (todo)``."""
        text = f"{self.where}: {self.what}" if self.where else self.what
        text = f"{text} ({self.todo})" if self.todo else text
        return " ".join(text.split())

    def __reduce__(self) -> tuple[Any, ...]:
        """Whole across a process border: class, text and fields, whatever its constructor takes."""
        return _again, (type(self), self.args, self.__dict__)


def _again(kind: type[C4SError], args: tuple[Any, ...], fields: dict[str, Any]) -> C4SError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(fields)
    return error


class BadInput(C4SError):
    """What the user gave cannot be used."""

    exit_code = 2


class MachineryFault(C4SError):
    """c4s, or a program that it runs, failed. Never a score."""

    exit_code = 3


class OverLimit(MachineryFault):
    """A process that c4s runs went over its time or its memory and was ended."""


class AgentFault(C4SError):
    """The agent under test failed. An outcome, not a fault of the run."""

    exit_code = 1
