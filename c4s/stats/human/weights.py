"""Weights of a text-to-scene score as four blocks of whole hundredths, and which of them a fit may choose.

Paper, ``sec:human-weight-fitting`` and ``tab:human-alignment-weights``. Hundredths because the search moves in steps of
0.05 and 0.01 and the paper prints two decimals: a policy is then exactly what is printed of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from c4s.protocol.rules import FAMILY_WEIGHTS, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS, T2S_WEIGHTS
from c4s.stats.bootstrap import Floats, Integers

WHOLE: Final = 100
GAMMA: Final = 20
"""Hundredths of the physical safety share, which no fit changes."""
LEAST_ALPHA: Final = 20
"""Least hundredths of the share of Detailed Alignment."""
_ALPHA, _GAMMA, _BETA = T2S_WEIGHTS
"""Names of the shares in the order in which a case score adds them; the paper lists alpha, beta, gamma."""
BLOCKS: Final[dict[str, tuple[str, ...]]] = {
    "families": tuple(FAMILY_WEIGHTS),
    "dimensions": tuple(OVERVIEW_WEIGHTS),
    "leaves": tuple(PHYSICS_LEAF_WEIGHTS),
    "final": tuple(T2S_WEIGHTS),
}
"""The parts of each block, in the order of the columns of a table of policies."""
_ENDS = np.cumsum([0, *map(len, BLOCKS.values())]).tolist()
SPANS: Final = {name: slice(start, end) for name, start, end in zip(BLOCKS, _ENDS, _ENDS[1:], strict=False)}
"""The columns of each block."""
COLUMNS: Final = _ENDS[-1]
ALPHA_AT: Final = SPANS["final"].start + list(T2S_WEIGHTS).index(_ALPHA)
BETA_AT: Final = SPANS["final"].start + list(T2S_WEIGHTS).index(_BETA)
GAMMA_AT: Final = SPANS["final"].start + list(T2S_WEIGHTS).index(_GAMMA)


@dataclass(frozen=True)
class SubscoreWeights:
    """The weights of one policy, each block by the names of its parts; each sums to 1."""

    families: Mapping[str, float]
    dimensions: Mapping[str, float]
    leaves: Mapping[str, float]
    final: Mapping[str, float]

    def hundredths(self) -> Integers:
        """As a row of a table of policies, shape (13,). ``ValueError`` for weights that are no whole hundredths."""
        given = [self.families, self.dimensions, self.leaves, self.final]
        flat = np.array([block[part] for block, parts in zip(given, BLOCKS.values(), strict=True) for part in parts])
        row: Integers = np.rint(flat * WHOLE).astype(np.int64)
        if np.abs(flat * WHOLE - row).max() > 1e-9 or any(row[span].sum() != WHOLE for span in SPANS.values()):
            raise ValueError("weights of whole hundredths that sum to 1 in each block are expected")
        return row

    @classmethod
    def of(cls, row: Integers) -> SubscoreWeights:
        """The policy of a row of hundredths."""
        parts = {
            name: dict(zip(BLOCKS[name], (row[span] / WHOLE).tolist(), strict=True)) for name, span in SPANS.items()
        }
        return cls(**parts)


ADOPTED: Final = SubscoreWeights(
    {str(name): weight for name, weight in FAMILY_WEIGHTS.items()}, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS, T2S_WEIGHTS
)
"""The published weights: the policy that fits are compared with."""


def simplex(parts: int, step: int) -> Integers:
    """All points of a block whose parts are multiples of ``step`` hundredths, shape (points, parts)."""
    if parts == 1:
        return np.full((1, 1), WHOLE, dtype=np.int64)
    heads = np.stack(np.meshgrid(*[np.arange(0, WHOLE + 1, step)] * (parts - 1), indexing="ij"), -1)
    rows = heads.reshape(-1, parts - 1)
    rows = rows[rows.sum(axis=1) <= WHOLE]
    return np.column_stack([rows, WHOLE - rows.sum(axis=1)])


def final_shares(alphas: Iterable[int]) -> Integers:
    """The final block for some shares of Detailed Alignment in hundredths, shape (alphas, 3)."""
    rows = []
    for alpha in alphas:
        share = {_ALPHA: alpha, _BETA: WHOLE - GAMMA - alpha, _GAMMA: GAMMA}
        rows.append([share[part] for part in BLOCKS["final"]])
    return np.array(rows, dtype=np.int64)


def feasible(table: Integers, applicable: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which policies a fit may choose, shape (policies,).

    Args:
        table: hundredths, shape (policies, 13).
        applicable: sets of families that prompts ask for, shape (sets, 4): each has to have some weight.
    """
    sums = np.all([table[:, span].sum(axis=1) == WHOLE for span in SPANS.values()], axis=0)
    shares = (table[:, GAMMA_AT] == GAMMA) & (table[:, ALPHA_AT] >= LEAST_ALPHA)
    weighed = (table[:, SPANS["families"]] @ applicable.T.astype(np.int64) > 0).all(axis=1)
    return np.asarray(sums & shares & weighed & (table >= 0).all(axis=1))


def as_shares(table: Integers) -> Floats:
    """Hundredths as weights."""
    return table / WHOLE
