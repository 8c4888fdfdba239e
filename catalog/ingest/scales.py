"""Factors from the units of files to metres: one for a folder, others for some files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path

import numpy as np

from c4s.errors import BadInput

LEAST, MOST = 1e-6, 1e6


@dataclass(frozen=True)
class ScaleChoice:
    """Metres per unit: ``default``, and pairs of a pattern of files and its own; the last that fits wins."""

    default: float
    of: tuple[tuple[str, float], ...] = ()

    @classmethod
    def parse(cls, default: float, rules: Sequence[str] = ()) -> ScaleChoice:
        """From options; rules are like ``chair*=0.01``. ``BadInput`` for others, and for no positive number."""
        pairs = []
        for rule in rules:
            pattern, _, text = rule.rpartition("=")
            factor = _factor(text)
            if not pattern or factor is None:
                raise BadInput("not a rule like chair*=0.01", where=f"--scale-of {rule}", todo="write PATTERN=FACTOR")
            pairs.append((pattern, factor))
        if _factor(str(default)) is None:
            raise BadInput("the scale must be a positive number", where=f"--scale {default}")
        return cls(default, tuple(pairs))

    def plain(self) -> list[object]:
        """As plain data: what a pack was built with."""
        return [self.default, *([pattern, factor] for pattern, factor in self.of)]

    def of_file(self, relative: str) -> float:
        """The factor of a file of the folder, by its path or its name."""
        fitting = [
            factor
            for pattern, factor in self.of
            if fnmatch(relative.lower(), pattern.lower()) or fnmatch(Path(relative).stem.lower(), pattern.lower())
        ]
        return fitting[-1] if fitting else self.default


def _factor(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if np.isfinite(value) and LEAST <= value <= MOST else None
