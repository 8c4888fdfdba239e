"""Where a judge's model is served, and with which key: from the environment, or from the operator's endpoints.

``C4S_JUDGE_URL`` (one address or several, with commas between) and ``C4S_JUDGE_KEY`` go before ``endpoints.yaml``.
Neither is part of a configuration, of its digest, or of any record.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Final

from c4s.chat.replicas import WIRE, Address, bearer
from c4s.errors import BadInput
from c4s.meter.endpoints import check_address, key_of, model_endpoint
from c4s.records.judge import JudgeConfiguration

URL_VARIABLE: Final = "C4S_JUDGE_URL"
KEY_VARIABLE: Final = "C4S_JUDGE_KEY"
PARALLEL: Final = 8
"""Requests of one submission's judge at once, where the endpoint names no other number."""


@dataclass(frozen=True)
class Served:
    """The addresses of a model, and how many requests they are given at once."""

    addresses: list[Address]
    parallel: int


def served(configuration: JudgeConfiguration) -> Served:
    """Where a configuration's model is reached. ``BadInput`` for an endpoint or key that is not there."""
    told = os.environ.get(URL_VARIABLE, "").strip()
    if told:
        urls = [url.strip() for url in told.split(",") if url.strip()]
        for url in urls:
            check_address(url, URL_VARIABLE)
        headers = bearer(os.environ.get(KEY_VARIABLE, "").strip() or None)
        return Served([Address(url, headers) for url in urls], PARALLEL)
    try:
        endpoint = model_endpoint(configuration.endpoint)
    except BadInput as error:
        todo = f"{error.todo}; or set {URL_VARIABLE} (docs/judge.md)"
        raise BadInput(f"judge {configuration.name!r}: {error.what}", where=error.where, todo=todo) from None
    if WIRE not in endpoint.formats:
        raise BadInput(
            f"judge {configuration.name!r} speaks {WIRE}, and endpoint {configuration.endpoint!r} speaks "
            + ", ".join(endpoint.formats)
        )
    key = key_of(configuration.endpoint, endpoint)
    name = (endpoint.key_header or "authorization").lower()
    headers = bearer(key) if name == "authorization" else ({} if key is None else {name: key})
    urls = [endpoint.url, *endpoint.replicas]
    return Served([Address(url, {**endpoint.headers, **headers}) for url in urls], endpoint.parallel or PARALLEL)
