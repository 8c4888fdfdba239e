"""What was read in a prompt: things, and which stand on or near which."""

from __future__ import annotations

from dataclasses import dataclass, field

from c4s.agents.baselines.english import PLACES, STRIPS
from c4s.agents.baselines.palette import PaletteItem


@dataclass(eq=False)
class Mention:
    """Something that the prose names: assets of the palette, or a place (with those of its floor, if any)."""

    noun: str
    items: tuple[PaletteItem, ...]
    said: frozenset[str] = frozenset()
    """The words before the noun."""
    count: int = 1
    counted: bool = False
    """Whether a number was said."""
    plural: bool = False

    @property
    def is_place(self) -> bool:
        """Whether it holds other things rather than stands anywhere."""
        return self.noun in PLACES

    @property
    def is_strip(self) -> bool:
        """Whether it runs through the whole scene."""
        return self.noun in STRIPS


@dataclass(frozen=True)
class Link:
    """A thing stands ``on`` another or ``near`` it."""

    kind: str
    thing: Mention
    other: Mention


@dataclass
class Prose:
    """What the prose says, in its order."""

    named: list[Mention] = field(default_factory=list)
    links: list[Link] = field(default_factory=list)
    size_m: tuple[float, float] | None = None
    """Length and width, where the text says how large the whole is."""


@dataclass(frozen=True)
class Chunk:
    """A part of a sentence."""

    kind: str
    """``noun``, ``on``, ``near``, ``verb``, ``and``, ``or``, ``comma``, or ``unknown``: something else stands here."""
    named: Mention | None = None
