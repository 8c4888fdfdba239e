"""The prompts of the model judge: a file each, with a version. What is in them is part of the judge's identity."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Final

from c4s.errors import MachineryFault
from c4s.files import digest_bytes

__all__ = ["Prompt", "prompt", "prompt_versions"]

PROMPTS: Final = ("arbitration", "paired", "prompt_aware", "prompt_free", "sight")
_FILE = re.compile(r"---\nname: (?P<name>[a-z_]+)\nversion: (?P<version>[1-9][0-9]*)\n---\n(?P<text>.+)", re.DOTALL)


@dataclass(frozen=True)
class Prompt:
    """A system prompt."""

    name: str
    version: int
    text: str
    sha256: str


@cache
def prompt(name: str) -> Prompt:
    """A prompt by name."""
    file = Path(__file__).parent / f"{name}.md"
    data = file.read_bytes()
    found = _FILE.fullmatch(data.decode())
    if found is None or found["name"] != name:
        raise MachineryFault("this prompt does not begin with its name and version", where=str(file))
    return Prompt(name, int(found["version"]), found["text"].strip(), digest_bytes(data))


@cache
def prompt_versions() -> dict[str, str]:
    """Every prompt's version with the digest of its file, by name."""
    return {name: f"{prompt(name).version}-{prompt(name).sha256[:12]}" for name in PROMPTS}
