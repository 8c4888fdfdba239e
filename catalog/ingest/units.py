"""Guesses from names and sizes whether a folder's unit is the metre, and proposes a factor where it is not."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import log
from statistics import median

TYPICAL_M: dict[str, tuple[float, float]] = {
    "chair": (0.7, 1.3),
    "armchair": (0.8, 1.3),
    "stool": (0.35, 1.0),
    "couch": (1.5, 2.6),
    "sofa": (1.5, 2.6),
    "bed": (1.8, 2.3),
    "desk": (1.0, 2.0),
    "table": (0.7, 2.2),
    "cabinet": (0.6, 2.1),
    "shelf": (0.6, 2.2),
    "bookcase": (0.8, 2.2),
    "wardrobe": (1.7, 2.4),
    "lamp": (0.3, 1.9),
    "door": (1.9, 2.4),
    "book": (0.15, 0.35),
    "fridge": (1.2, 2.0),
    "oven": (0.6, 1.2),
    "stove": (0.6, 1.2),
    "sink": (0.4, 1.2),
    "toilet": (0.6, 0.9),
    "bathtub": (1.4, 1.9),
    "plate": (0.15, 0.35),
    "pot": (0.15, 0.45),
    "pan": (0.25, 0.6),
    "knife": (0.15, 0.4),
    "bottle": (0.15, 0.35),
    "mug": (0.08, 0.15),
    "bowl": (0.12, 0.35),
    "crate": (0.3, 1.0),
    "barrel": (0.6, 1.1),
    "pallet": (0.8, 1.4),
    "car": (3.5, 5.2),
    "taxi": (3.8, 5.2),
    "truck": (5.0, 9.0),
    "bus": (8.0, 13.0),
    "streetlight": (3.5, 10.0),
    "trafficlight": (2.5, 6.0),
    "bench": (1.2, 2.2),
    "firehydrant": (0.6, 1.2),
    "hydrant": (0.6, 1.2),
    "dumpster": (1.5, 3.0),
    "building": (5.0, 40.0),
    "house": (5.0, 20.0),
    "tree": (2.0, 15.0),
    "sign": (1.8, 3.5),
    "rug": (1.2, 3.0),
    "pillow": (0.35, 0.7),
    "monitor": (0.4, 0.8),
    "computer": (0.3, 0.8),
}
"""Longest side in metres of things as they are usually made."""
OTHER_UNITS = (0.01, 0.001, 0.0254, 100.0, 10.0)
"""Centimetre, millimetre, inch, and files that were made a hundred or ten times too small; metres per unit."""

FACTORS = (0.01, 0.001, 0.0254, 100.0, 1000.0, 39.37)
"""Metres per unit of centimetres, millimetres and inches, and the other way round."""
UNLIKE = 30.0
WRONG_UNIT = 10.0
"""A named thing this many times out of its usual sizes is in another unit; toys and large ones are not."""
FREE_FACTOR = 1.3
"""A median this far off says nothing yet about the unit."""


@dataclass(frozen=True)
class UnitCheck:
    """What the sizes of a folder say.

    ``implausible`` sizes out of ``known`` that a name explains; ``proposed`` is the factor to give as ``--scale``, or
    ``None`` when the sizes are fine or nothing speaks for another.
    """

    known: int
    implausible: int
    proposed: float | None
    reason: str


def words(name: str) -> list[str]:
    """``car_hatchback`` and ``CarHatchback2`` as lower-case words; numbers are left out."""
    split = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", re.sub(r"[^A-Za-z]+", " ", name))
    return [word.lower() for word in split.split()]


def check_units(sizes_m: Iterable[tuple[str, float]]) -> UnitCheck:
    """Compare the longest sides (m) of named things with those of real ones."""
    named, sides = [], []
    for name, side in sizes_m:
        sides.append(side)
        known = next((TYPICAL_M[word] for word in words(name) if word in TYPICAL_M), None)
        if known:
            named.append((side, known))
    wrong = [one for one in named if not one[1][0] / FREE_FACTOR <= one[0] <= one[1][1] * FREE_FACTOR]
    if len(named) >= 3:
        factor = median((low * high) ** 0.5 / side for side, (low, high) in named)
        if not 1 / FREE_FACTOR <= factor <= FREE_FACTOR:
            return UnitCheck(
                len(named),
                len(wrong),
                _two_digits(factor),
                f"{len(named)} things whose names tell their "
                f"size are {1 / factor:.2g} times as long as real ones (median)",
            )
    middle = median(sides) if sides else 1.0
    if not named and not 0.02 <= middle <= 60:
        fitting = [unit for unit in OTHER_UNITS if 0.1 <= middle * unit <= 10]
        return UnitCheck(
            0,
            0,
            fitting[0] if fitting else _two_digits(1 / middle),
            f"the middle of the longest sides is {middle:.4g} m",
        )
    return UnitCheck(len(named), len(wrong), None, "sizes are plausible" if named else "no name tells a size")


@dataclass(frozen=True)
class OddSize:
    """A file whose unit is another one than that of the rest: its factor to metres by the unit that fits, and why."""

    factor: float
    reason: str


def odd_sizes(sizes_m: Sequence[tuple[str, float]]) -> dict[int, OddSize]:
    """Which of the named longest sides (m) are in another unit than the others, by their place.

    A name that tells a size decides; else a side that is ``UNLIKE`` times longer or shorter than the middle of the
    folder. Only one of ``FACTORS`` is proposed, and where nothing fits the side is told alone.
    """
    middle = median([side for _, side in sizes_m]) if sizes_m else 1.0
    found = {}
    for index, (name, side) in enumerate(sizes_m):
        known = next((TYPICAL_M[word] for word in words(name) if word in TYPICAL_M), None)
        low, high = known or (middle / UNLIKE, middle * UNLIKE)
        if low / WRONG_UNIT <= side <= high * WRONG_UNIT:
            continue
        target = (low * high) ** 0.5
        fitting = [unit for unit in FACTORS if low / FREE_FACTOR <= side * unit <= high * FREE_FACTOR]
        if not fitting:
            if not known and not 1 / (UNLIKE * WRONG_UNIT) <= side <= UNLIKE * WRONG_UNIT:
                found[index] = OddSize(1.0, f"it is {side:.3g} m long, the middle of the folder {middle:.3g} m")
            continue
        best = min(fitting, key=lambda unit: abs(log(side * unit / target)))
        told = f"a real one is {low:g} to {high:g} m" if known else f"the middle of the folder is {middle:.3g} m"
        found[index] = OddSize(best, f"it is {side:.3g} m long and {told}")
    return found


def _two_digits(value: float) -> float:
    return float(f"{value:.2g}")
