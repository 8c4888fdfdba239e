"""The word net: what things are called, what kind they are, and what they are for (``word_net.txt``)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files

from c4s.toolbox.search.words import stem_of, words_of

EQUAL, KIND, USE = 0.6, 0.5, 0.35
"""How much a thing's other names, its kind and its uses count beside its own name."""
FAR = 0.6
"""What is left of a weight a step further up the kinds."""
MOST_STEPS = 3

Name = tuple[str, ...]
"""Stems of a name: ``("traffic", "light")``."""


@dataclass(frozen=True)
class WordThing:
    """One line of the word net."""

    names: tuple[Name, ...]
    kinds: tuple[str, ...]
    uses: tuple[str, ...]
    told: str
    """Its kinds and uses as they are written."""


class WordNet:
    """Things by their names."""

    def __init__(self, lines: Sequence[str]) -> None:
        self._things: dict[Name, list[WordThing]] = {}
        self._widened: dict[Name, Mapping[str, float]] = {}
        for line in lines:
            if not line.strip() or line.startswith("#"):
                continue
            names, kinds, uses = line.split("|")
            thing = WordThing(
                tuple(tuple(map(stem_of, words_of(name))) for name in names.split(",")),
                tuple(map(stem_of, words_of(kinds))),
                tuple(map(stem_of, words_of(uses))),
                " ".join(words_of(kinds) + words_of(uses)),
            )
            for name in thing.names:
                self._things.setdefault(name, []).append(thing)
        self.longest = max(map(len, self._things))

    def named(self, stems: Sequence[str]) -> list[tuple[Name, int]]:
        """The names that stand in a row of stems with their places; the longest counts at each place."""
        found, at = [], 0
        while at < len(stems):
            for length in range(min(self.longest, len(stems) - at), 0, -1):
                name = tuple(stems[at : at + length])
                if name in self._things:
                    found.append((name, at))
                    at += length
                    break
            else:
                at += 1
        return found

    def told(self, name: Name) -> list[str]:
        """What its lines tell of a name: kinds and uses, in words."""
        return [thing.told for thing in self._things.get(name, ())]

    def widen(self, name: Name) -> Mapping[str, float]:
        """Stems that go with a name, each with its weight (0 to 1)."""
        if name not in self._widened:
            self._widened[name] = self._spread(name)
        return self._widened[name]

    def _spread(self, name: Name) -> dict[str, float]:
        weights: dict[str, float] = {}
        seen: set[Name] = set()
        front, factor = [name], 1.0
        for step in range(MOST_STEPS):
            following: list[Name] = []
            for one in front:
                seen.add(one)
                for thing in self._things.get(one, ()):
                    equal = [stem for other in thing.names for stem in other] if not step else []
                    for stems, weight in ((equal, EQUAL), (thing.kinds, KIND), (thing.uses, USE)):
                        for stem in stems:
                            weights[stem] = max(weights.get(stem, 0.0), factor * weight)
                    following += [(kind,) for kind in thing.kinds if (kind,) not in seen]
            front, factor = following, factor * FAR
        return weights


@lru_cache(maxsize=1)
def word_net() -> WordNet:
    """The word net of this package, read when it is first asked for."""
    return WordNet((files("c4s.toolbox.search") / "word_net.txt").read_text(encoding="utf-8").splitlines())
