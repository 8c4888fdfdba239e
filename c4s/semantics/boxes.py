"""World boxes in one table, and a tree over them that answers, for many boxes at once, whether a relation holds to any.

A relation is written once, as ``holds(subjects, least, most)``: whether each subject may stand in it to a box whose
facts lie between ``least`` and ``most``. With the two equal it is the relation itself; with the two exchanged it says
that the relation holds to every box in between. So a branch of the tree is refused or accepted as a whole.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.semantics.inventory import Array, Thing

Flags: TypeAlias = NDArray[np.bool_]
Rows: TypeAlias = NDArray[np.int64]
SMALLEST_CM = 0.1
"""A box counts as at least this thick where its volume is asked for."""
CHUNK = 1 << 15
"""Pairs that are looked at together: they bound the memory."""
_BITS = 10


@dataclass(frozen=True)
class Boxes:
    """Boxes as rows: corners, height, larger plan side, volume, number of the owner, smaller plan side."""

    table: Array

    @classmethod
    def of(cls, things: Sequence[Thing]) -> Boxes:
        """The boxes of things, in their order."""
        numbers: dict[tuple[str, str], int] = {}
        owners = [numbers.setdefault((thing.actor, thing.kind.asset), len(numbers)) for thing in things]
        low, high = (np.array([getattr(thing, side) for thing in things]).reshape(-1, 3) for side in ("low", "high"))
        size = high - low
        thick = np.maximum(size, SMALLEST_CM)
        volume = thick[:, 0] * thick[:, 1] * thick[:, 2]
        columns = (low, high, size[:, 2], size[:, :2].max(axis=1), volume, owners, size[:, :2].min(axis=1))
        return cls(np.column_stack(columns))

    def take(self, rows: Rows | Flags) -> Boxes:
        """Some of the boxes."""
        return Boxes(self.table[rows])

    @property
    def low(self) -> Array:
        """Lower corners (cm)."""
        return self.table[:, :3]

    @property
    def high(self) -> Array:
        """Upper corners (cm)."""
        return self.table[:, 3:6]

    @property
    def centre(self) -> Array:
        """Centres (cm)."""
        return (self.low + self.high) / 2

    @property
    def height(self) -> Array:
        """Extents along z (cm)."""
        return self.table[:, 6]

    @property
    def plan_size(self) -> Array:
        """The larger of the extents along x and y (cm)."""
        return self.table[:, 7]

    @property
    def volume(self) -> Array:
        """Volumes (cm³)."""
        return self.table[:, 8]

    @property
    def owner(self) -> Array:
        """Numbers of the owners: things of one actor and one asset, such as instances, have one."""
        return self.table[:, 9]

    @property
    def thickness(self) -> Array:
        """The smaller of the extents along x and y (cm)."""
        return self.table[:, 10]


Relation: TypeAlias = Callable[[Boxes, Boxes, Boxes], Flags]


def morton_order(keys: Array) -> Rows:
    """An order in which rows that are alike in all their keys stand close together."""
    code = np.zeros(len(keys), dtype=np.int64)
    for column in range(keys.shape[1]):
        values, rank = np.unique(keys[:, column], return_inverse=True)
        rank = rank * ((1 << _BITS) - 1) // max(1, len(values) - 1)
        for bit in range(_BITS):
            code |= (rank >> bit & 1) << (bit * keys.shape[1] + column)
    return np.argsort(code, kind="stable")


class BoundsTree:
    """The rows of a table under a full binary tree, with the least and the most of every column in each branch."""

    def __init__(self, table: Array, keys: Array) -> None:
        self.order = morton_order(keys)
        """Row of the table at each leaf."""
        width = 1 << max(0, len(table) - 1).bit_length()
        leaves = table[self.order]
        padding = np.full((width - len(table), table.shape[1]), np.inf)
        least, most = np.concatenate([leaves, padding]), np.concatenate([leaves, -padding])
        count = np.arange(width) < len(table)
        self.levels = [(least, most, count.astype(np.int64))]
        """``(least, most, rows below)`` of the branches of each level, from the root down."""
        while len(least) > 1:
            least, most = np.minimum(least[::2], least[1::2]), np.maximum(most[::2], most[1::2])
            self.levels.append((least, most, self.levels[-1][2].reshape(-1, 2).sum(axis=1)))
        self.levels.reverse()


def holds_to_any(subjects: Sequence[Thing], references: Sequence[Thing], holds: Relation) -> Flags:
    """Whether each subject stands in the relation to any reference but itself."""
    found = np.zeros(len(subjects), dtype=bool)
    if not len(subjects) or not references:
        return found
    table = Boxes.of([*subjects, *references]).table
    mine, theirs = Boxes(table[: len(subjects)]), Boxes(table[len(subjects) :])
    tree = BoundsTree(theirs.table, theirs.table[:, :6])
    place = {id(thing): number for number, thing in enumerate(references)}
    own = np.array([place.get(id(thing), -1) for thing in subjects])
    stack: list[tuple[int, Rows, Rows]] = [(0, np.arange(len(subjects)), np.zeros(len(subjects), dtype=np.int64))]
    while stack:
        level, rows, nodes = stack.pop()
        rows, nodes = rows[~found[rows]], nodes[~found[rows]]
        least, most, count = tree.levels[level]
        possible = holds(mine.take(rows), Boxes(least[nodes]), Boxes(most[nodes]))
        rows, nodes = rows[possible], nodes[possible]
        if level == len(tree.levels) - 1:
            found[rows[tree.order[nodes] != own[rows]]] = True
            continue
        sure = holds(mine.take(rows), Boxes(most[nodes]), Boxes(least[nodes])) & (count[nodes] > 1)
        found[rows[sure]] = True
        rows, nodes = np.repeat(rows[~sure], 2), (2 * nodes[~sure][:, None] + np.arange(2)).ravel()
        stack += [(level + 1, rows[i : i + CHUNK], nodes[i : i + CHUNK]) for i in range(0, len(rows), CHUNK)]
    return found
