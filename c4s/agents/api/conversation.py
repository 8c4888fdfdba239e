"""The conversation of the API loop: messages in the chat format, and how it is kept within the model's context.

A tool's result is the text of a ``tool`` message; its pictures follow in a ``user`` message after the turn's results.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

CHARACTERS_A_TOKEN = 3.5
PICTURE_TOKENS = 1600
KEPT_RESULT_CHARACTERS = 400
KEPT_TURNS = 4
"""The last turns, which are never shortened."""
REMOVED = "[an earlier picture was removed to save room]"
CUT = " ... [the rest of this earlier result was removed to save room]"


@dataclass
class Turn:
    """One answer of the model with the results of its calls."""

    assistant: dict[str, Any]
    results: list[dict[str, Any]] = field(default_factory=list)
    pictures: list[dict[str, Any]] = field(default_factory=list)
    """Parts of the user message after the results."""

    def messages(self) -> list[dict[str, Any]]:
        """The turn as messages."""
        shown = [{"role": "user", "content": self.pictures}] if self.pictures else []
        return [self.assistant, *self.results, *shown]


@dataclass(frozen=True)
class Trimming:
    """What one trimming took out, and the estimated tokens before and after."""

    before_tokens: int
    after_tokens: int
    pictures_removed: int
    results_shortened: int
    turns_removed: int


def picture_part(png: bytes, kind: str = "image/png") -> dict[str, Any]:
    """A picture as a part of a user message."""
    return {"type": "image_url", "image_url": {"url": f"data:{kind};base64,{base64.b64encode(png).decode()}"}}


class Conversation:
    """The messages. ``head`` and the tools that go with every request are never trimmed."""

    def __init__(self, head: Sequence[dict[str, Any]], tools: Sequence[dict[str, Any]] = ()) -> None:
        self.head = list(head)
        self._tool_tokens = len(json.dumps(list(tools))) / CHARACTERS_A_TOKEN
        self.turns: list[Turn] = []
        self._scale = 1.0

    def messages(self) -> list[dict[str, Any]]:
        """All messages in order."""
        return [*self.head, *(message for turn in self.turns for message in turn.messages())]

    def tokens(self) -> int:
        """Estimated tokens of the prompt, scaled by what the model said of earlier prompts."""
        return int(self._scale * self._raw_tokens())

    def _raw_tokens(self) -> float:
        return self._tool_tokens + sum(_tokens(message) for message in self.messages())

    def learn(self, prompt_tokens: int | None) -> None:
        """Correct the estimate by what the model counted for the prompt as it stands."""
        raw = self._raw_tokens()
        if prompt_tokens and raw:
            self._scale = prompt_tokens / raw

    def trim(self, target_tokens: int) -> Trimming | None:
        """Bring the estimate below the target; None where nothing can be taken out.

        First the oldest pictures, then long results, then whole turns, each from the oldest on, and each only as far
        as needed. The head and the last turns stay.
        """
        before, counts = self.tokens(), [0, 0, 0]
        for step, take in enumerate((_remove_pictures, _shorten_results)):
            for turn in self.turns[:-KEPT_TURNS]:
                if self.tokens() <= target_tokens:
                    break
                counts[step] += take(turn)
        while self.tokens() > target_tokens and len(self.turns) > KEPT_TURNS:
            del self.turns[0]
            counts[2] += 1
        return Trimming(before, self.tokens(), *counts) if any(counts) else None


def _tokens(message: dict[str, Any]) -> float:
    content = message.get("content")
    parts = content if isinstance(content, list) else [{"type": "text", "text": content or ""}]
    total = 4.0 + len(json.dumps(message.get("tool_calls") or [])) / CHARACTERS_A_TOKEN
    for part in parts:
        total += PICTURE_TOKENS if part["type"] == "image_url" else len(part["text"]) / CHARACTERS_A_TOKEN
    return total


def _remove_pictures(turn: Turn) -> int:
    found = len([part for part in turn.pictures if part["type"] == "image_url"])
    turn.pictures = [
        {"type": "text", "text": REMOVED} if part["type"] == "image_url" else part for part in turn.pictures
    ]
    return found


def _shorten_results(turn: Turn) -> int:
    shortened = 0
    for number, result in enumerate(turn.results):
        if len(result["content"]) > KEPT_RESULT_CHARACTERS + len(CUT):
            turn.results[number] = {**result, "content": result["content"][:KEPT_RESULT_CHARACTERS] + CUT}
            shortened += 1
    return shortened
