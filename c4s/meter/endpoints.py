"""Model endpoints: where the meter sends requests, and in which environment variable the operator keeps the key."""

from __future__ import annotations

import os
from pathlib import Path
from urllib.parse import urlsplit

from pydantic import Field

from c4s.errors import BadInput
from c4s.files import read_yaml
from c4s.home import home
from c4s.meter.wire import BY_NAME
from c4s.meter.wire.base import Wire
from c4s.records.base import Record


class ModelEndpoint(Record):
    """An upstream. ``url`` is the base that a client of the format would be given."""

    url: str
    formats: list[str]
    """Wire formats that it speaks: ``openai-chat``, ``openai-responses``, ``anthropic``, ``gemini``."""
    key_env: str | None = None
    """Name of the environment variable with the key; null where none is needed (a self-hosted server)."""
    key_header: str | None = None
    """Header for the key where it is not the format's own; ``authorization`` is sent as a bearer token."""
    headers: dict[str, str] = Field(default_factory=dict)
    """Further headers of every request."""
    replicas: list[str] = Field(default_factory=list)
    """Further addresses that serve the same models. A judge spreads its requests over all; agents use ``url``."""
    parallel: int | None = Field(default=None, ge=1, le=256)
    """Requests of one submission's judge at once, over all addresses."""

    def header_of(self, wire: Wire | None) -> str:
        """The header that carries the key."""
        return (self.key_header or (wire.key_header if wire else BY_NAME[self.formats[0]].key_header)).lower()


class EndpointFile(Record):
    """The operator's ``endpoints.yaml``."""

    endpoints: dict[str, ModelEndpoint] = Field(default_factory=dict)
    spending_limit_usd: float | None = Field(default=None, ge=0)
    """The most a run may spend on models; null for no limit."""


KNOWN = {
    "openai": ModelEndpoint(
        url="https://api.openai.com/v1", formats=["openai-chat", "openai-responses"], key_env="OPENAI_API_KEY"
    ),
    "anthropic": ModelEndpoint(url="https://api.anthropic.com", formats=["anthropic"], key_env="ANTHROPIC_API_KEY"),
    "gemini": ModelEndpoint(
        url="https://generativelanguage.googleapis.com", formats=["gemini"], key_env="GEMINI_API_KEY"
    ),
    "openrouter": ModelEndpoint(
        url="https://openrouter.ai/api/v1", formats=["openai-chat", "openai-responses"], key_env="OPENROUTER_API_KEY"
    ),
    "openrouter-anthropic": ModelEndpoint(
        url="https://openrouter.ai/api", formats=["anthropic"], key_env="OPENROUTER_API_KEY", key_header="authorization"
    ),
}
LIMIT_VARIABLE = "C4S_SPENDING_LIMIT_USD"


def endpoint_path() -> Path:
    """``C4S_ENDPOINTS``, else ``endpoints.yaml`` in ``C4S_HOME``."""
    return Path(os.environ.get("C4S_ENDPOINTS") or home() / "endpoints.yaml")


def endpoint_file() -> EndpointFile:
    """The operator's file, or an empty one. ``BadInput`` for a file that cannot be used."""
    path = endpoint_path()
    if not path.exists() and not os.environ.get("C4S_ENDPOINTS"):
        return EndpointFile()
    return EndpointFile.parse(read_yaml(path) or {}, where=str(path))


def model_endpoint(name: str) -> ModelEndpoint:
    """An endpoint by name: the operator's, else a known one. ``BadInput`` for a name or address that is neither."""
    own = endpoint_file().endpoints
    found = own.get(name) or KNOWN.get(name)
    if found is None:
        raise BadInput(
            f"unknown model endpoint {name!r}",
            where=str(endpoint_path()),
            todo=f"describe it there, or use one of {', '.join(sorted({**KNOWN, **own}))}",
        )
    for url in (found.url, *found.replicas):
        check_address(url, f"model endpoint {name!r}")
    unknown = set(found.formats) - set(BY_NAME)
    if unknown or not found.formats:
        raise BadInput(f"model endpoint {name!r} names no wire format of {', '.join(BY_NAME)}")
    return found


def check_address(url: str, what: str) -> None:
    """``BadInput`` for what is no HTTP address."""
    try:
        address = urlsplit(url)
    except ValueError:
        address = urlsplit("")
    if address.scheme not in ("http", "https") or not address.hostname:
        raise BadInput(f"{what} has no http address: {url!r}")


def key_of(name: str, endpoint: ModelEndpoint) -> str | None:
    """The real key. ``BadInput`` when its variable is not set."""
    if endpoint.key_env is None:
        return None
    key = os.environ.get(endpoint.key_env, "").strip()
    if not key:
        raise BadInput(f"the key of model endpoint {name!r} is missing", todo=f"set {endpoint.key_env}")
    return key


def spending_limit() -> float | None:
    """US dollars that a run may spend: ``C4S_SPENDING_LIMIT_USD``, else the operator's file, else none."""
    told = os.environ.get(LIMIT_VARIABLE, "").strip()
    if not told:
        return endpoint_file().spending_limit_usd
    try:
        limit = float(told)
    except ValueError:
        limit = -1.0
    if not 0 <= limit < float("inf"):
        raise BadInput(f"{LIMIT_VARIABLE} is {told!r}, not an amount in US dollars")
    return limit
