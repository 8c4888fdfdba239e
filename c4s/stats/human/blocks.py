"""Who ranks what: balanced incomplete blocks over seven candidates (paper, ``sec:human-alignment``).

Seven triplets a prompt hold every candidate three times and each of the 21 pairs once: the Fano plane. Who ranks a
triplet is a Fano plane again, of annotators: three rank each triplet, each ranks three triplets of a prompt, and any
two of them share exactly one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

BLOCK_SIZE: Final = 3
POINTS: Final = 7
"""Candidates of a prompt, annotators, and triplets of a prompt."""
_BASE: Final = (0, 1, 3)
"""A difference set modulo 7: its differences are 1 to 6, each once."""
Triplet = tuple[int, int, int]


@dataclass(frozen=True)
class RankedBlock:
    """A ranking task of one prompt."""

    candidates: Triplet
    """Numbers of candidates, in the order in which they are shown."""
    annotators: Triplet


def fano_plane() -> tuple[Triplet, ...]:
    """Seven triplets of the numbers 0 to 6; any two numbers are in exactly one."""
    first, second, third = _BASE
    return tuple(((first + n) % POINTS, (second + n) % POINTS, (third + n) % POINTS) for n in range(POINTS))


def blocks(prompts: int, seed: int) -> list[list[RankedBlock]]:
    """The blocks of each prompt: candidates, annotators, and the order of each triplet are drawn anew for each.

    Args:
        prompts: their number.
        seed: it alone decides (PCG64).
    """
    random = np.random.default_rng(seed)
    drawn = []
    for _ in range(prompts):
        candidates, annotators = random.permutation(POINTS), random.permutation(POINTS)
        drawn.append(
            [
                RankedBlock(_renamed(random.permutation(shown), candidates), _renamed(np.array(ranking), annotators))
                for shown, ranking in zip(fano_plane(), fano_plane(), strict=True)
            ]
        )
    return drawn


def split(prompts: int, seed: int, held_out: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Numbers of the development and of the holdout prompts, both rising.

    Prompts are shuffled by the seed and the last ones are held out; scores have no part in it. The paper tells the
    seed and not the algorithm: number the prompts in the order of their names.

    ``ValueError`` where no prompt would be left on either side.
    """
    if not 0 < held_out < prompts:
        raise ValueError("a prompt on either side of the split is expected")
    order = np.random.default_rng(seed).permutation(prompts).tolist()
    return tuple(sorted(order[:-held_out])), tuple(sorted(order[-held_out:]))


def _renamed(places: np.ndarray, names: np.ndarray) -> Triplet:
    first, second, third = names[places].tolist()
    return first, second, third
