"""A judge as a pinned configuration: what it is called, and everything that its answers depend on beside the
evidence."""

from __future__ import annotations

from typing import Any, Final, Literal, Self

from pydantic import Field, model_validator

from c4s.names import Name
from c4s.records.base import Record

JudgeKind = Literal["rule", "model"]
_OF_THE_JUDGE: Final = frozenset({"messages", "response_format", "stream", "n"})
"""Fields of a request that no configuration sets."""
_NO_IDENTITY = {"endpoint", "timeout_s"}
"""Where a model is served and how long is waited for it changes no answer."""


class JudgeConfiguration(Record):
    """A judge. Its name is its label in tables; its digest, with its prompts and code, is the judge's version."""

    name: Name
    kind: JudgeKind = "model"
    """``rule``: the offline rule judge. ``model``: a vision model behind an OpenAI-compatible endpoint."""
    model: str | None = None
    """Id of the model, as its endpoint calls it."""
    endpoint: str = "judge"
    """Name of the model endpoint (``endpoints.yaml``). No part of the judge's identity, nor are its addresses or
    key."""
    thinking: bool | None = False
    """On or off; null leaves it to the endpoint."""
    thinking_field: Literal["chat_template", "openrouter", "openai"] = "chat_template"
    """How the endpoint is told: the chat template's ``enable_thinking``, ``reasoning``, or ``reasoning_effort``."""
    temperature: float | None = Field(default=0.0, ge=0, le=2)
    seed: int | None = 0
    max_tokens: int = Field(default=16_000, gt=0)
    """Of one answer."""
    claims_per_request: int = Field(default=8, ge=1, le=64)
    pictures_per_request: int = Field(default=6, ge=4, le=64)
    """At most; the four overview views have to fit."""
    timeout_s: float = Field(default=600.0, gt=0)
    """Seconds without an answer after which a request is tried again. No part of the judge's identity."""
    extra: dict[str, Any] = Field(default_factory=dict)
    """Further fields of every request, such as a router's provider choice; none that it has without them."""

    @model_validator(mode="after")
    def _extra_is_further(self) -> Self:
        taken = self.extra.keys() & (_OF_THE_JUDGE | self._told().keys())
        if taken:
            raise ValueError(f"extra sets {min(taken)!r}, which every request has already")
        return self

    def identity(self) -> dict[str, Any]:
        """The part of the configuration that can change an answer."""
        return {name: value for name, value in self.plain().items() if name not in _NO_IDENTITY}

    def request_fields(self) -> dict[str, Any]:
        """Fields of every request, without messages and schema."""
        return {**self._told(), **self.extra}

    def _told(self) -> dict[str, Any]:
        plain = {"temperature": self.temperature, "seed": self.seed, "max_tokens": self.max_tokens}
        told = {name: value for name, value in plain.items() if value is not None}
        return {"model": self.model, **told, **self._thinking()}

    def _thinking(self) -> dict[str, Any]:
        if self.thinking is None:
            return {}
        if self.thinking_field == "openrouter":
            return {"reasoning": {"enabled": self.thinking}}
        if self.thinking_field == "openai":
            return {"reasoning_effort": "medium" if self.thinking else "none"}
        return {"chat_template_kwargs": {"enable_thinking": self.thinking}}


RULE_JUDGE = JudgeConfiguration(name="rule", kind="rule")
"""The offline rule judge, the only one of its kind."""
