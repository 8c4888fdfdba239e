"""What a worked score is made of: steps, each a number with the parts that it comes of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Final

COUNT: Final = "count"


@dataclass(frozen=True)
class Addend:
    """One of the numbers that a step is made of."""

    label: str
    value: float | None
    weight: float | None = None
    """Null where it is not weighed: a count, a cap."""
    note: str = ""
    kind: str = ""
    """How it was decided, as the class of a mark: ``match``, ``unknown``, ...; ``count``; empty for a number."""
    anchor: str = ""
    """Of what tells more of it on the same page."""

    @property
    def share(self) -> float | None:
        """What it adds to a weighted sum."""
        return None if self.value is None or self.weight is None else self.value * self.weight


@dataclass(frozen=True)
class Step:
    """One number: the rule, its parts, what they come to here, and what was stored."""

    name: str
    """Of the anchor, unique in its working."""
    title: str
    rule: str
    """The rule in words or signs."""
    parts: Sequence[Addend]
    made: float | None
    """Computed from the parts, rounded where the protocol rounds; null where nothing is measured."""
    stored: float | None
    digits: int = 4
    """Decimals that it is shown with."""
    inner: Sequence[Step] = ()
    """Steps that its parts come of."""
    note: str = ""

    @property
    def agrees(self) -> bool:
        """Whether what was computed is what was stored, to the last digit of a double."""
        return self.made == self.stored

    def all(self) -> Iterator[Step]:
        """The step after those that it is made of."""
        for step in self.inner:
            yield from step.all()
        yield self


@dataclass(frozen=True)
class Working:
    """How a case score came about, or why it is zero without being measured."""

    steps: Sequence[Step]
    """The components first, the case score last; empty where nothing was measured."""
    gate: str
    """What decided whether it was measured."""
    passed: bool
    missing: Sequence[str] = field(default=())
    """Components that were not evaluated and are worth zero."""

    def all(self) -> list[Step]:
        """Every number."""
        return [one for step in self.steps for one in step.all()]

    @property
    def agrees(self) -> bool:
        """Whether every number is the stored one."""
        return all(step.agrees for step in self.all())
