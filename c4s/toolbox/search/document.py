"""What is searched: one thing's name, tags and texts, and how its meaning is put into words for the sentence model."""

from __future__ import annotations

import re
from dataclasses import dataclass

from c4s.toolbox.search.net import word_net
from c4s.toolbox.search.words import EMPTY, stems_of, words_of

NAME, TAGS = 4.0, 2.0
"""Weights of a name's and of tags' words, which say what a thing is and are looked up in the word net."""
LEAST_TERM = 3
_SPOKEN = re.compile(r"[^\W\d_]{2,}")


@dataclass(frozen=True)
class Document:
    """The texts of one thing; ``texts`` come with their weights."""

    name: str
    tags: tuple[str, ...]
    texts: tuple[tuple[str, float], ...]

    @property
    def named(self) -> tuple[tuple[str, float], ...]:
        """The texts that say what it is, with their weights."""
        return (self.name, NAME), (" ".join(self.tags), TAGS)

    @property
    def plain_name(self) -> str:
        """The name in lower case without numbers and single letters: chair A and chair B mean the same."""
        return " ".join(_SPOKEN.findall(self.name)).lower() or self.name.lower()

    @property
    def line(self) -> str:
        """Its name, its other tags and what the word net tells of it: what the sentence model reads of it."""
        net, stems = word_net(), stems_of(self.name)
        told = [tag for tag in self.tags if not set(stems_of(tag)) <= set(stems)]
        for name, _ in net.named(stems):
            told += net.told(name)
        return f"{self.plain_name}: {', '.join(told)}" if told else self.plain_name

    @property
    def terms(self) -> tuple[str, ...]:
        """What it is called, in single terms: its tags, its name, the words of its name."""
        words = [word for word in words_of(self.name) if len(word) >= LEAST_TERM and not word.isdigit()]
        return tuple(
            dict.fromkeys(
                [*(tag.lower() for tag in self.tags), *(word for word in words if word not in EMPTY), self.plain_name]
            )
        )
