"""The model that extracts requirements: an endpoint of the operator's, asked through the shared chat client."""

from __future__ import annotations

import random
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from c4s.chat.client import ChatClient, Reply
from c4s.chat.failures import ChatFailed
from c4s.chat.replicas import WIRE, Address, bearer
from c4s.errors import BadInput, MachineryFault
from c4s.meter.endpoints import key_of, model_endpoint
from cases.graphs.extraction import Ask

_NO_THINKING: dict[str, dict[str, Any]] = {
    "openrouter": {"reasoning": {"enabled": False}},
    "openai": {"reasoning_effort": "none"},
}
SELF_HOSTED: dict[str, Any] = {"chat_template_kwargs": {"enable_thinking": False}}


def no_thinking(endpoint: str) -> dict[str, Any]:
    """The fields that switch thinking off at an endpoint (paper, Judge configuration)."""
    return _NO_THINKING.get(endpoint, SELF_HOSTED)


def address_of(name: str) -> Address:
    """Where an endpoint is reached, with its key. ``BadInput`` for one that is not there, or speaks another format."""
    endpoint = model_endpoint(name)
    if WIRE not in endpoint.formats:
        raise BadInput(f"extraction speaks {WIRE}, and endpoint {name!r} speaks {', '.join(endpoint.formats)}")
    key, header = key_of(name, endpoint), (endpoint.key_header or "authorization").lower()
    headers = bearer(key) if header == "authorization" else ({} if key is None else {header: key})
    return Address(endpoint.url, {**endpoint.headers, **headers})


@contextmanager
def asking(name: str, note: Callable[[str], None], wait: Callable[[float], bool] | None = None) -> Iterator[Ask]:
    """What asks the model at an endpoint; ``note`` is told of every failure, ``wait`` waits between tries.

    A failure that tries do not mend is ``BadInput`` where the endpoint refuses the request, else ``MachineryFault``.
    """
    client = ChatClient(
        [address_of(name)],
        wait=wait or threading.Event().wait,
        jitter=random.Random(name),
        note=lambda record: note(f"{record['class']}: {record['what'][:200]} (try {record['try']})"),
    )

    def ask(body: Mapping[str, Any]) -> Reply:
        try:
            return client.ask(body)
        except ChatFailed as failure:
            kind = BadInput if failure.kind in ("refused", "context") else MachineryFault
            raise kind(failure.what, where=name) from failure

    try:
        yield ask
    finally:
        client.close()
