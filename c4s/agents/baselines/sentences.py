"""The links that one sentence says: its subject, what stands on or near what, what its lists go on with."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.agents.baselines.reading import Chunk, Link, Mention, Prose

RELATIONS = ("on", "near")


def relate(chunks: Sequence[Chunk], reading: Prose) -> None:
    """Add the links that a sentence says."""
    sentence = Sentence(reading)
    for place, chunk in enumerate(chunks):
        sentence.take(chunk, chunks[place + 1].kind if place + 1 < len(chunks) else "")


class Sentence:
    """Reads chunks one by one: what is the subject, what was named last, which relation waits for its other side."""

    def __init__(self, reading: Prose) -> None:
        self._reading = reading
        self._subject: list[Mention] = []
        self._phrase: list[Mention] = []
        self._front: tuple[str, Mention] | None = None
        """A relation that was said before its subject."""
        self._waiting, self._left = "", list[Mention]()
        self._given, self._owner = "", list[Mention]()
        """The relation that was said last, and its left side: a list goes on with it."""
        self._verb = self._listed = self._choice = False

    def take(self, chunk: Chunk, upcoming: str) -> None:
        """The next part of the sentence, and the kind of the one behind it."""
        if chunk.named is not None:
            self._choose(chunk.named) if self._choice else self._noun(chunk.named, upcoming)
        elif chunk.kind in RELATIONS:
            self._left = self._subject if self._verb else self._phrase[-1:]
            self._waiting = self._given = chunk.kind
            self._listed = False
        elif chunk.kind == "verb":
            self._verb = True
        elif chunk.kind == "unknown":
            self._waiting = ""
        elif chunk.kind == "or":
            self._choice = bool(self._phrase)
        else:
            self._listed = True

    def _choose(self, named: Mention) -> None:
        """``a monitor or a laptop``: one thing of either kind."""
        self._choice = False
        if named in self._reading.named and named is not self._phrase[-1]:
            self._phrase[-1].items += named.items
            self._reading.named.remove(named)

    def _noun(self, found: Mention, upcoming: str) -> None:
        listed, self._listed = self._listed and bool(self._phrase), False
        if self._waiting:
            self._answer(found)
        elif listed and upcoming == "verb" and (self._phrase is not self._subject or self._verb):
            self._start(found)
        elif listed and self._given and not self._verb and upcoming not in RELATIONS:
            self._phrase = [*self._phrase, found]
            self._add(self._given, self._owner, found)
        elif listed and self._phrase is self._subject and (not self._verb or not upcoming):
            self._subject = self._phrase = [*self._subject, found]
            self._follow(found)
        elif self._verb and self._subject and not listed:
            self._add("near", self._subject, found)
            self._phrase = [found]
        else:
            self._start(found)

    def _answer(self, found: Mention) -> None:
        """The other side of the relation that waits; one without a left side speaks of what follows it."""
        if self._left:
            self._add(self._waiting, self._left, found)
        else:
            self._front = (self._waiting, found)
        self._waiting, self._owner, self._phrase = "", self._left, [found]

    def _start(self, found: Mention) -> None:
        """A new subject."""
        self._subject = self._phrase = [found]
        self._given, self._verb, self._owner = "", False, []
        self._follow(found)

    def _follow(self, found: Mention) -> None:
        """What a fronted phrase says of the subjects behind it."""
        if self._front is not None:
            self._add(self._front[0], [found], self._front[1])

    def _add(self, kind: str, left: Sequence[Mention], right: Mention) -> None:
        self._reading.links += [Link(kind, named, right) for named in left if named is not right]
