"""From pictures to a description: a model looks and writes, and what is wrong with it is sent back for a new one."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources import files
from pathlib import Path
from typing import Any, Final

from PIL import Image

from c4s.chat.client import Reply
from c4s.errors import BadInput, MachineryFault
from c4s.protocol.graph.prompt import description_end

INSTRUCTIONS: Final = files("cases.drafting").joinpath("instructions.md").read_text()
FEWEST_WORDS, MOST_WORDS = 50, 250
"""Of a description, as in the paper."""
MOST_PARAGRAPHS: Final = 3
MOST_PICTURES: Final = 8
MOST_BYTES: Final = 8 << 20
"""Of one picture."""
MAX_TOKENS: Final = 2048
DRAFT_REPAIRS: Final = 3
_KINDS: Final = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg"}
_MARKUP: Final = re.compile(r"^\s*(?:#{1,6} |[-*•] |\d+[.)] |```|===)", re.MULTILINE)
_META: Final = re.compile(r"\b(?:screenshots?|in the (?:picture|image|photo)s?|cameras?)\b", re.IGNORECASE)
Ask = Callable[[Mapping[str, Any]], Reply]
"""Asks a model once; raises what the chat client raises."""


@dataclass
class Drafted:
    """A description and how it came about."""

    text: str
    answers: int
    """How many the model gave."""
    faults: list[str] = field(default_factory=list)
    """What was wrong with the answers before."""


def draft_description(
    pictures: Sequence[Path],
    model: str,
    ask: Ask,
    *,
    about: str = "",
    repairs: int = DRAFT_REPAIRS,
    fields: Mapping[str, Any] | None = None,
) -> Drafted:
    """Let a model describe what pictures show.

    Args:
        pictures: PNG or JPEG files of one scene, at most ``MOST_PICTURES``.
        model: id of the model.
        ask: sends one request.
        about: what the author says of the place, such as its title.
        repairs: most answers after the first.
        fields: further fields of each request.

    Raises ``BadInput`` for pictures that cannot be sent, ``MachineryFault`` when no answer can be used.
    """
    shown = _shown(pictures)
    faults: list[str] = []
    said: list[dict[str, Any]] = []
    for number in range(repairs + 1):
        reply = ask(_request(model, shown, about, said, fields or {}))
        text, wrong = _read(reply)
        if not wrong:
            return Drafted(text, number + 1, faults)
        faults += [f"answer {number + 1}: {line}" for line in wrong]
        told = "\n".join(f"- {line}" for line in wrong)
        said = [
            {"role": "assistant", "content": text},
            {"role": "user", "content": f"This is wrong with your description:\n{told}\nWrite it anew."},
        ]
    raise MachineryFault(
        f"the model gave no description that can be used in {repairs + 1} answers: {'; '.join(wrong[:3])}",
        where=model,
        todo="try another model, or more repairs",
    )


def _shown(pictures: Sequence[Path]) -> list[dict[str, Any]]:
    if not pictures:
        raise BadInput("there is no picture to describe", todo="name PNG or JPEG files of the scene")
    if len(pictures) > MOST_PICTURES:
        raise BadInput(f"{len(pictures)} pictures, at most {MOST_PICTURES} are sent", todo="choose some of them")
    return [_part(picture) for picture in pictures]


def _part(picture: Path) -> dict[str, Any]:
    kind = _KINDS.get(picture.suffix.lower())
    if kind is None:
        raise BadInput("only PNG and JPEG pictures are sent", where=str(picture))
    if not picture.is_file():
        raise BadInput("there is no such picture", where=str(picture))
    if picture.stat().st_size > MOST_BYTES:
        raise BadInput(f"this picture is larger than {MOST_BYTES >> 20} MiB", where=str(picture))
    try:
        with Image.open(picture) as opened:
            opened.verify()
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise BadInput(f"this is no picture that can be read: {str(error)[:100]}", where=str(picture)) from None
    return {
        "type": "image_url",
        "image_url": {"url": f"data:{kind};base64,{base64.b64encode(picture.read_bytes()).decode()}"},
    }


def _request(
    model: str, shown: Sequence[dict[str, Any]], about: str, said: Sequence[dict[str, Any]], fields: Mapping[str, Any]
) -> dict[str, Any]:
    words = f"The author calls this place: {about}" if about else "These pictures show one place."
    return {
        "model": model,
        "messages": [
            {"role": "system", "content": INSTRUCTIONS},
            {"role": "user", "content": [{"type": "text", "text": words}, *shown]},
            *said,
        ],
        "temperature": 0,
        "seed": 0,
        "max_tokens": MAX_TOKENS,
        **fields,
    }


def _read(reply: Reply) -> tuple[str, list[str]]:
    """The description of an answer, and what is wrong with it."""
    content = reply.message.get("content")
    text = content.strip() if isinstance(content, str) else ""
    if not text:
        return "", ["it is empty"]
    if reply.finish == "length":
        return text[:2000], [f"it was cut at its output limit: at most {MOST_WORDS} words are wanted"]
    paragraphs = [" ".join(part.split()) for part in re.split(r"\n\s*\n", text)]
    text = "\n\n".join(paragraphs)
    words, wrong = len(text.split()), []
    if not FEWEST_WORDS <= words <= MOST_WORDS:
        wrong.append(f"it has {words} words, {FEWEST_WORDS} to {MOST_WORDS} are wanted")
    if len(paragraphs) > MOST_PARAGRAPHS:
        wrong.append(f"it has {len(paragraphs)} paragraphs, at most {MOST_PARAGRAPHS} are wanted")
    if _MARKUP.search(content or "") or description_end(text) != len(text):
        wrong.append("it has headings or lists; plain prose is wanted")
    if found := _META.search(text):
        wrong.append(f"it speaks of {found.group().lower()!r}; only the place is wanted")
    return text if len(text) < 20_000 else text[:2000], wrong
