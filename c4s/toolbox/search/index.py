"""The index: documents of weighted words, widened by the word net, ranked by BM25 with fields (BM25F)."""

from __future__ import annotations

import bisect
import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from c4s.toolbox.search.net import word_net
from c4s.toolbox.search.words import stems_of

SATURATION, LENGTH = 1.6, 0.25
"""``k1`` and ``b`` of BM25."""
MISSED = 0.35
"""Share of a score that does not depend on how many of the query's words were met."""
LEAST_PREFIX, PREFIX = 4, 0.5
"""A query word that no document has stands for the words that begin with it, or that it begins with."""


@dataclass(frozen=True)
class Document:
    """The texts of one thing with their weights; ``names`` say what it is and are looked up in the word net."""

    names: tuple[tuple[str, float], ...]
    texts: tuple[tuple[str, float], ...]


class Index:
    """Ranks documents for a query. Reproducible: equal documents and query give equal scores."""

    def __init__(self, documents: Sequence[Document]) -> None:
        weighted = [_weights(document) for document in documents]
        lengths = np.array([sum(weights.values()) for weights in weighted] or [1.0])
        self._size = len(weighted)
        norm = SATURATION * (1 - LENGTH + LENGTH * lengths / max(float(lengths.mean()), 1e-9))
        rows: dict[str, list[tuple[int, float]]] = defaultdict(list)
        for number, weights in enumerate(weighted):
            for stem, weight in weights.items():
                rows[stem].append((number, weight))
        self._posting: dict[str, tuple[NDArray[np.intp], NDArray[np.float64]]] = {}
        for stem, found in rows.items():
            which = np.array([number for number, _ in found], dtype=np.intp)
            weights_of_stem = np.array([value for _, value in found])
            rarity = math.log(1 + (self._size - len(found) + 0.5) / (len(found) + 0.5))
            self._posting[stem] = which, rarity * weights_of_stem / (weights_of_stem + norm[which])
        self._sorted = sorted(self._posting)

    def scores(self, query: str) -> NDArray[np.float64]:
        """A score for each document, 0 where nothing fits."""
        total, met = np.zeros(self._size), np.zeros(self._size)
        wanted = list(dict.fromkeys(stems_of(query)))
        for stem in wanted:
            best = np.zeros(self._size)
            for other, factor in self._like(stem):
                which, values = self._posting[other]
                best[which] = np.maximum(best[which], factor * values)
            total += best
            met += best > 0
        return total * (MISSED + (1 - MISSED) * met / max(len(wanted), 1))

    def _like(self, stem: str) -> list[tuple[str, float]]:
        """Stems of the index that stand for a query's stem, with a factor."""
        if stem in self._posting:
            return [(stem, 1.0)]
        if len(stem) < LEAST_PREFIX:
            return []
        found = []
        start = bisect.bisect_left(self._sorted, stem)
        for other in self._sorted[start:]:
            if not other.startswith(stem):
                break
            found.append((other, PREFIX))
        found += [(stem[:end], PREFIX) for end in range(LEAST_PREFIX, len(stem)) if stem[:end] in self._posting]
        return found + [
            (stem[start:], PREFIX) for start in range(1, len(stem) - LEAST_PREFIX + 1) if stem[start:] in self._posting
        ]


def _weights(document: Document) -> dict[str, float]:
    """Weight of each stem of a document: the sum over its fields, or what the word net adds, whichever is more."""
    own: dict[str, float] = defaultdict(float)
    added: dict[str, float] = {}
    net = word_net()
    for text, weight in document.names:
        stems = stems_of(text)
        for stem in stems:
            own[stem] += weight
        for name, _ in net.named(stems):
            for stem, share in net.widen(name).items():
                added[stem] = max(added.get(stem, 0.0), weight * share)
    for text, weight in document.texts:
        for stem in dict.fromkeys(stems_of(text)):
            own[stem] += weight
    for stem, weight in added.items():
        own[stem] = max(own.get(stem, 0.0), weight)
    return dict(own)
