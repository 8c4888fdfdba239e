"""Which assets of a palette a noun of the prose means."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property

from c4s.agents.baselines.english import COLOURS, MEASURES, SIZES, SYNONYMS
from c4s.agents.baselines.palette import PaletteItem, singular

HEAD, FORM, PART, SYNONYM = 3.0, 2.5, 1.0, 1.6
"""What a noun is worth: it ends a name, says what a tile or row is of, stands elsewhere in it, or means the same."""
SAID, NEARBY, UNSAID, TAKEN = 2.0, 0.6, 0.3, 0.5
ALIKE = 0.05
FLAT_SHARE = 0.06
LONG = 3.0
LONG_WORD, LIKE = 7, 0.9
"""Letters from which on a noun may be misspelt, and how alike the two spellings are then."""
SETS = frozenset({"bp", "set"})


@dataclass(frozen=True)
class AssetName:
    """A palette item and the words of its name, singular."""

    item: PaletteItem

    @cached_property
    def words(self) -> tuple[str, ...]:
        """Without digits and single letters."""
        found = re.findall(r"[a-z]{2,}", re.sub(r"[\d_]+", " ", self.item.name).lower())
        return tuple(singular(word) for word in found)

    @cached_property
    def core(self) -> tuple[str, ...]:
        """Without the colours and sizes that end it, and without the words of sets."""
        words = [word for word in self.words if word not in SETS]
        while len(words) > 1 and (words[-1] in COLOURS or words[-1] in SIZES):
            words.pop()
        return tuple(words)

    @cached_property
    def variant(self) -> frozenset[str]:
        """The colours and sizes that end it."""
        return frozenset(self.words) - frozenset(self.core) - SETS

    def worth(self, noun: str) -> float:
        """How far the noun names it; 0 where it does not."""
        if not self.core:
            return 0.0
        if noun == self.core[-1]:
            return HEAD
        if len(self.core) > 1 and self.core[-1] in MEASURES and noun == self.core[-2]:
            return FORM
        return PART if noun in self.core else 0.0


class Names:
    """The names of a palette."""

    def __init__(self, palette: Sequence[PaletteItem], text: str) -> None:
        self._names = [AssetName(item) for item in palette]
        prose = " " + " ".join(singular(word) for word in re.findall(r"[a-z]+", text.lower())) + " "
        self._spelled = {name for name in self._names if len(name.core) > 1 and f" {' '.join(name.core)} " in prose}
        self._spellings: dict[str, str] = {}
        self.nouns = {word for name in self._names for word in name.core}
        self.heads = {name.core[-1] for name in self._names if name.core} | {
            name.core[-2] for name in self._names if len(name.core) > 1 and name.core[-1] in MEASURES
        }

    def _spelt(self, noun: str) -> str:
        """A noun as the palette spells it: names are often misspelt (``waterffall``)."""
        if noun in self.nouns or len(noun) < LONG_WORD:
            return noun
        if noun not in self._spellings:
            near = get_close_matches(noun, sorted(self.heads), n=1, cutoff=LIKE)
            self._spellings[noun] = near[0] if near else noun
        return self._spellings[noun]

    def stem(self, word: str) -> str:
        """A word of the prose as names have it: singular, and ``cobbled`` as ``cobble``."""
        word = singular(word)
        stems = [word.removesuffix(ending) for ending in ("d", "ed") if word.endswith("ed") and word not in self.nouns]
        return next((stem for stem in stems if stem in self.nouns), word)

    def knows(self, noun: str) -> bool:
        """Whether a noun may name something of the palette."""
        return self._spelt(noun) in self.nouns or self.means(noun)

    def means(self, noun: str) -> bool:
        """Whether it is what something of the palette is."""
        return self._spelt(noun) in self.heads or any(other in self.heads for other in SYNONYMS.get(noun, ()))

    def of(
        self, noun: str, said: Sequence[str], nearby: Collection[str], *, plural: bool = False
    ) -> tuple[PaletteItem, ...]:
        """The items that a noun means, by the words before it and those of its sentence: one, or variants of one."""
        worth = {name: self._worth(name, noun) for name in self._names}
        if not (best := max(worth.values(), default=0.0)):
            return ()
        chosen = [name for name in self._names if worth[name] >= min(best, SYNONYM)]
        score = {name: worth[name] + self._fit(name, noun, said, nearby) for name in chosen}
        size = sum(SIZES.get(word, 0) for word in said)
        if size:
            ranked = sorted(chosen, key=lambda name: max(name.item.width, name.item.depth) * name.item.height * size)
            for place, name in enumerate(ranked):
                score[name] += NEARBY * place / len(ranked)
        top = max(score.values())
        loose = TAKEN if best == PART else ALIKE
        found = [name for name in chosen if score[name] >= top - loose]
        if best == PART and not plural:
            found = [max(found, key=lambda name: max(name.item.width, name.item.depth))]
        elif best > PART:
            found = [name for name in found if name.core == found[0].core]
        alike = [name for name in chosen if name.core == found[0].core and name not in found]
        hinted = [name for name in alike if name.variant and name.variant <= {*nearby, *said}]
        if not found[0].variant & set(said):
            found += hinted
        return tuple(name.item for name in found)

    def _worth(self, name: AssetName, noun: str) -> float:
        own = name.worth(self._spelt(noun))
        meant = (SYNONYM for other in SYNONYMS.get(noun, ()) if name.worth(other) >= FORM)
        return max([own, *meant])

    def _fit(self, name: AssetName, noun: str, said: Collection[str], nearby: Collection[str]) -> float:
        fit = 0.0
        for word in set(name.core) - {noun} - MEASURES:
            fit += SAID if word in said else NEARBY if word in nearby else -UNSAID
        fit += sum(SAID / 2 if word in said else NEARBY if word in nearby else 0.0 for word in name.variant)
        if name in self._spelled and not set(name.core) - {noun} <= {*said}:
            fit -= TAKEN
        return fit - (TAKEN if SETS & set(name.words) else 0.0)


def is_flat(item: PaletteItem) -> bool:
    """Whether an item lies on the ground: a tile, a rug."""
    return item.height <= max(FLAT_SHARE * min(item.width, item.depth), 0.03)


def is_long(item: PaletteItem) -> bool:
    """Whether it is a piece of a wall, a quay, a railing."""
    return max(item.width, item.depth) >= max(1.0, LONG * min(item.width, item.depth))
