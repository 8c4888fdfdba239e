"""Requests as documents: what is sent, with pictures by their digest, so that equal requests have one digest.

The document is stored as it is; what goes over the wire is the same with the pictures put in.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from c4s.files import digest
from c4s.judge.model.prompts import prompt
from c4s.judge.model.sights import ShownPicture
from c4s.records.judge import JudgeConfiguration
from c4s.records.judgement import Purpose

Document = dict[str, Any]
_BY_DIGEST = "sha256:"


@dataclass(frozen=True)
class Request:
    """One logical request."""

    purpose: Purpose
    document: Document
    pictures: Mapping[str, str]
    """Data URLs by SHA-256."""
    views: tuple[str, ...]
    """Names of the captures' views, as the document's ``view-1`` ... stand for them."""
    claims: tuple[str, ...] = ()
    """Ids of the claims, as the document's ``c1`` ... stand for them."""
    again: bool = False

    @cached_property
    def sha256(self) -> str:
        """Digest of the document."""
        return digest(self.document)

    def shown(self) -> set[str]:
        """SHA-256 of the pictures that the document names."""
        contents = [message["content"] for message in self.document["messages"]]
        parts = [part for content in contents if not isinstance(content, str) for part in content]
        return {_picture_of(part) for part in parts if part["type"] == "image_url"}

    def body(self) -> Document:
        """The document with its pictures put in."""
        return {**self.document, "messages": [self._filled(message) for message in self.document["messages"]]}

    def _filled(self, message: Mapping[str, Any]) -> Document:
        content = message["content"]
        if isinstance(content, str):
            return dict(message)
        return {**message, "content": [self._part(part) for part in content]}

    def _part(self, part: Mapping[str, Any]) -> Mapping[str, Any]:
        if part["type"] != "image_url":
            return part
        return {"type": "image_url", "image_url": {"url": self.pictures[_picture_of(part)]}}


@dataclass
class Writer:
    """Makes requests under one configuration."""

    configuration: JudgeConfiguration
    _fields: Document = field(init=False)

    def __post_init__(self) -> None:
        """The fields that every request has."""
        self._fields = self.configuration.request_fields()

    def write(
        self,
        purpose: Purpose,
        prompt_name: str,
        shown: Sequence[tuple[str, ShownPicture]],
        *,
        before: str = "",
        after: str = "",
        schema: Mapping[str, Any],
        claims: Sequence[str] = (),
        again: bool = False,
    ) -> Request:
        """A request: the prompt, the text ``before`` the pictures, the pictures, and the text ``after`` them.

        Args:
            purpose: which rung or call it is.
            prompt_name: its system prompt.
            shown: views by their names in the captures.
            schema: of the answer.
            claims: ids of the claims that it asks for.
            again: whether it asks anew for what an answer broke.
        """
        content: list[Document] = [_text(before)] if before else []
        for name, (_, picture) in zip(view_names(len(shown)), shown, strict=True):
            content += [_text(f"{name}:"), {"type": "image_url", "image_url": {"url": _BY_DIGEST + picture.sha256}}]
        content += [_text(after)] if after else []
        document = {
            **self._fields,
            "messages": [{"role": "system", "content": prompt(prompt_name).text}, {"role": "user", "content": content}],
            "response_format": {
                "type": "json_schema",
                "json_schema": {"name": purpose, "strict": True, "schema": schema},
            },
        }
        return Request(
            purpose,
            document,
            {picture.sha256: picture.url for _, picture in shown},
            tuple(name for name, _ in shown),
            tuple(claims),
            again,
        )


def view_names(count: int) -> list[str]:
    """What so many views are called in a request."""
    return [f"view-{number}" for number in range(1, count + 1)]


def claim_names(count: int) -> list[str]:
    """What so many claims are called in a request."""
    return [f"c{number}" for number in range(1, count + 1)]


def told(value: Any) -> str:
    """Data as a request's text shows it."""
    return json.dumps(value, ensure_ascii=False, indent=1)


def _picture_of(part: Mapping[str, Any]) -> str:
    return str(part["image_url"]["url"]).removeprefix(_BY_DIGEST)


def _text(text: str) -> Document:
    return {"type": "text", "text": text}
