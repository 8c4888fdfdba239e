"""What can go wrong with a request for a completion, by class, and how often each is tried again.

========================== ============================== ==========================================
class                      what it is                     what is done
========================== ============================== ==========================================
``connection``             no connection, a broken answer again, up to 5 times, from 1 s
``timeout``                no answer in time, 408, 504    again, up to 3 times, from 2 s
``rate``                   429                            again, up to 10 times, from 5 s, or as told
``server``                 409, 425, 5xx, 529             again, up to 6 times, from 2 s, or as told
``malformed``              an answer without a message    again, up to 3 times, from 1 s
``context``                the prompt is too long         raised: the caller shortens and asks again
``refused``                any other status (400, 401 ..) raised
========================== ============================== ==========================================

Waits double, with jitter, up to 60 s; ``Retry-After`` is kept up to 10 minutes. Waiting ends when the run does.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from typing import Final, Literal

from c4s.errors import MachineryFault

ErrorClass = Literal["connection", "timeout", "rate", "server", "malformed", "context", "refused"]
TRIES: Final[dict[ErrorClass, int]] = {
    "connection": 5,
    "timeout": 3,
    "rate": 10,
    "server": 6,
    "malformed": 3,
    "context": 0,
    "refused": 0,
}
FIRST_WAIT_S: Final[dict[ErrorClass, float]] = {"connection": 1, "timeout": 2, "rate": 5, "server": 2, "malformed": 1}
LONGEST_WAIT_S, LONGEST_TOLD_WAIT_S = 60.0, 600.0
OF_THE_ADDRESS: Final[frozenset[ErrorClass]] = frozenset({"connection", "timeout", "rate", "server"})
"""Classes that say something of the address that was asked, not of the request."""
_TOO_LONG = re.compile(
    r"context[ _-]?(length|window|limit)|maximum context|too many tokens|prompt is too long"
    r"|input is too long|exceeds? the .*token|reduce the length",
    re.IGNORECASE,
)


class ChatFailed(MachineryFault):
    """A request that will not succeed by asking again. ``kind`` says of which class its error is."""

    def __init__(self, kind: ErrorClass, what: str, status: int | None = None) -> None:
        super().__init__(what, todo="see to the model endpoint, then run the same command again")
        self.kind, self.status = kind, status


class ChatEnded(ChatFailed):
    """A request that was given up because the run ended while it waited to try again."""


@dataclass(frozen=True)
class Failure:
    """One try that brought no message."""

    kind: ErrorClass
    what: str
    status: int | None = None
    told_wait_s: float | None = None


def failure_of(status: int, text: str, retry_after: str | None = None) -> Failure:
    """The failure of an answer with another status than 200."""
    told = None
    if retry_after and re.fullmatch(r"\d+(\.\d+)?", retry_after.strip()):
        told = min(float(retry_after), LONGEST_TOLD_WAIT_S)
    kind: ErrorClass = "refused"
    if status in (400, 413, 422) and _TOO_LONG.search(text):
        kind = "context"
    elif status in (408, 504):
        kind = "timeout"
    elif status == 429:
        kind = "rate"
    elif status in (409, 425) or status >= 500:
        kind = "server"
    return Failure(kind, f"status {status}: {_message(text)}", status, told)


def _message(text: str) -> str:
    try:
        error = json.loads(text)["error"]
        return str(error["message"] if isinstance(error, dict) else error)
    except (ValueError, KeyError, TypeError, RecursionError):
        return text
