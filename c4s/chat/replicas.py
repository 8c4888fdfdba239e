"""Addresses that serve one model: which of them a request goes to, and which are set aside for a while.

An address that fails is set aside, from 5 s up to 5 minutes, longer each time, or as it told; meanwhile requests go to
the others. When its time is over it is asked again, and one good answer makes it whole. Where all are set aside,
requests go to the one that is due first: whether that is a fault is decided by the tries of their error's class.
"""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from c4s.errors import BadInput

WIRE: Final = "openai-chat"
"""The wire format that is spoken."""
_NAME: Final = re.compile(r"[-!#$%&'*+.^_`|~0-9A-Za-z]+")
_VALUE: Final = re.compile(r"(?:[\x21-\x7e](?:[\t\x20-\x7e]*[\x21-\x7e])?)?")
FIRST_ASIDE_S, LONGEST_ASIDE_S = 5.0, 300.0


@dataclass(frozen=True)
class Address:
    """Base address of an OpenAI-compatible server, with the headers that carry its key."""

    url: str
    headers: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """``BadInput``, without the value, for a header that HTTP does not carry."""
        for name, value in self.headers.items():
            if not _NAME.fullmatch(name) or not _VALUE.fullmatch(value):
                raise BadInput(
                    f"the header {name!r} of a model endpoint holds a character that HTTP does not carry",
                    todo="see to its key, or to `headers` in endpoints.yaml",
                )


def bearer(token: str | None) -> dict[str, str]:
    """The headers of a bearer token; none where no key is needed."""
    return {} if token is None else {"Authorization": f"Bearer {token}"}


@dataclass
class Replica:
    """One address and how it does."""

    address: Address
    busy: int = 0
    """Requests that wait for its answer."""
    failures: int = 0
    """In a row."""
    aside_until: float = 0.0


class Replicas:
    """The addresses of one model. Safe for threads."""

    def __init__(self, addresses: Sequence[Address], clock: Callable[[], float] = time.monotonic) -> None:
        self._all = [Replica(address) for address in addresses]
        self._clock = clock
        self._lock = threading.Lock()

    def take(self) -> Replica:
        """The least busy address that is not set aside; where all are, the one that is due first."""
        with self._lock:
            now = self._clock()
            free = [replica for replica in self._all if replica.aside_until <= now]
            if free:
                chosen = min(free, key=lambda replica: replica.busy)
            else:
                chosen = min(self._all, key=lambda replica: replica.aside_until)
            chosen.busy += 1
            return chosen

    def good(self, replica: Replica) -> None:
        """It answered."""
        with self._lock:
            replica.busy -= 1
            replica.failures, replica.aside_until = 0, 0.0

    def let_go(self, replica: Replica) -> None:
        """The request is over, and says nothing of the address."""
        with self._lock:
            replica.busy -= 1

    def failed(self, replica: Replica, told_wait_s: float | None) -> bool:
        """It failed: set it aside. Whether another address can be asked at once."""
        with self._lock:
            replica.busy -= 1
            replica.failures += 1
            wait = min(FIRST_ASIDE_S * 2.0 ** (replica.failures - 1), LONGEST_ASIDE_S)
            now = self._clock()
            replica.aside_until = now + (wait if told_wait_s is None else told_wait_s)
            return any(other.aside_until <= now for other in self._all if other is not replica)
