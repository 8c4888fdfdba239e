"""Options of the agent ``api`` in a configuration."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from c4s.records.base import Record
from c4s.records.plan import Configuration


class ApiOptions(Record):
    """``options`` of a configuration with ``client: api``."""

    endpoint: str = "openrouter"
    side_models: list[str] = Field(default_factory=list)
    thinking: bool | None = None
    """On or off; null leaves it to the endpoint."""
    effort: str | None = None
    """Reasoning effort, where the endpoint has levels."""
    thinking_field: Literal["openrouter", "openai", "chat_template"] | None = None
    """How the endpoint is told: ``reasoning``, ``reasoning_effort`` or the chat template's ``enable_thinking``. By
    default as OpenRouter and OpenAI want it at those, and by the chat template at a self-hosted endpoint."""
    pictures: bool = True
    """Whether the model takes pictures; without, it is told that a picture was made."""
    temperature: float | None = Field(default=None, ge=0)
    top_p: float | None = Field(default=None, gt=0, le=1)
    seed: int | None = None
    """Sent where it is set; endpoints that offer no seed refuse or ignore it."""
    max_tokens: int | None = Field(default=None, gt=0)
    context_tokens: int = Field(default=128_000, ge=8_000)
    """The model's context; the conversation is trimmed before it is full."""
    max_turns: int = Field(default=2_000, gt=0)
    same_calls: int = Field(default=12, gt=1)
    """So many identical turns in a row end the run: the model is in a loop. Asking for the state of a job is none."""
    extra: dict[str, Any] = Field(default_factory=dict)
    """Further fields of every request, such as a router's provider choice."""

    @staticmethod
    def of(configuration: Configuration) -> ApiOptions:
        """The options of a configuration; ``BadInput`` for an unknown or bad one."""
        return ApiOptions.parse(configuration.options, where=configuration.name)

    def request_fields(self) -> dict[str, Any]:
        """Fields of every request, without model, messages and tools."""
        plain = {"temperature": self.temperature, "top_p": self.top_p, "seed": self.seed, "max_tokens": self.max_tokens}
        return {**{name: value for name, value in plain.items() if value is not None}, **self._thinking(), **self.extra}

    def _thinking(self) -> dict[str, Any]:
        if self.thinking is None and self.effort is None:
            return {}
        known = {"openrouter": "openrouter", "openai": "openai"}
        field = self.thinking_field or known.get(self.endpoint, "chat_template")
        on = self.thinking is not False
        if field == "openrouter":
            return {"reasoning": {"enabled": on, **({"effort": self.effort} if on and self.effort else {})}}
        if field == "openai":
            return {"reasoning_effort": (self.effort or "medium") if on else "none"}
        effort = {"reasoning_effort": self.effort} if on and self.effort else {}
        return {"chat_template_kwargs": {"enable_thinking": on}, **effort}
