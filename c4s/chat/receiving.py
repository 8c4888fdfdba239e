"""One request over HTTP: its whole answer, within a time and a size, and without the key that it was asked with."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final

import httpx

from c4s.chat.failures import Failure
from c4s.chat.replicas import Address

MOST_BYTES: Final = 32 << 20
"""Of an answer; the longest completion has a few."""
_LEAST_SECRET: Final = 8
"""A shorter header value is no secret: it may stand in any text."""
_HIDDEN: Final = b"***"


@dataclass(frozen=True)
class Received:
    """An answer of any status."""

    status: int
    retry_after: str | None
    data: bytes

    @property
    def text(self) -> str:
        """Its body as UTF-8, whatever it calls itself."""
        return self.data.decode(errors="replace")


def received(
    http: httpx.Client, address: Address, body: Mapping[str, Any], *, within_s: float, clock: Callable[[], float]
) -> Received | Failure:
    """What an address answers. An answer that is not whole in time is a timeout, however steadily it drips."""
    ends = clock() + within_s
    data = bytearray()
    url = f"{address.url.rstrip('/')}/chat/completions"
    try:
        with http.stream("POST", url, json=body, headers=dict(address.headers)) as answer:
            for part in answer.iter_bytes():
                data += part
                if len(data) > MOST_BYTES:
                    return Failure("malformed", f"an answer of more than {MOST_BYTES} bytes")
                if clock() > ends:
                    return Failure("timeout", f"the answer was not whole after {within_s:g} s")
            return Received(answer.status_code, answer.headers.get("retry-after"), _hidden(bytes(data), address))
    except httpx.TimeoutException as error:
        return Failure("timeout", f"{type(error).__name__}: {error}")
    except (httpx.HTTPError, httpx.InvalidURL) as error:
        return Failure("connection", f"{type(error).__name__}: {error}")


def _hidden(data: bytes, address: Address) -> bytes:
    """An answer without what it repeats of the request's headers: it is stored, and may be published."""
    for secret in _secrets(address):
        data = data.replace(secret.encode(), _HIDDEN)
    return data


def _secrets(address: Address) -> Iterator[str]:
    for value in address.headers.values():
        secret = value.removeprefix("Bearer ")
        if len(secret) >= _LEAST_SECRET:
            yield secret
