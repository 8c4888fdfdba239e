"""A guessed repair, and which of many guesses are made."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from c4s.agents.baselines.blind.scene import Vector

SURE = 0.5
"""Guesses at least this likely are all made; where there is none, the likeliest one is: a wrong one costs nothing."""
MOST = 12


@dataclass(frozen=True)
class Guess:
    """One repair: ``delete`` an actor, ``place`` it elsewhere, show another ``mesh``, or ``copy`` it to a place."""

    actor: str
    edit: Literal["delete", "place", "mesh", "copy"]
    trick: str
    chance: float
    """How likely it is to be right, from 0 to 1."""
    location: Vector | None = None
    rotation: Vector | None = None
    scale: Vector | None = None
    mesh: str | None = None

    @property
    def what(self) -> tuple[object, ...]:
        """What is done, whatever led to it."""
        return self.actor, self.edit, self.location, self.rotation, self.scale, self.mesh


def chosen(guesses: Sequence[Guess]) -> list[Guess]:
    """The guesses that are made, the likeliest first: one an actor; what several tricks say is likelier."""
    said: dict[tuple[object, ...], list[Guess]] = defaultdict(list)
    for guess in guesses:
        said[guess.what].append(guess)
    likely = sorted(((_together(of), of[0]) for of in said.values()), key=lambda row: (-row[0], row[1].actor))
    made: dict[str, tuple[float, Guess]] = {}
    for chance, guess in likely:
        made.setdefault(guess.actor, (chance, guess))
    sure = [guess for chance, guess in made.values() if chance >= SURE][:MOST]
    return sure or [guess for _, guess in made.values()][:1]


def _together(guesses: Sequence[Guess]) -> float:
    return 1 - math.prod(1 - guess.chance for guess in {guess.trick: guess for guess in guesses}.values())
