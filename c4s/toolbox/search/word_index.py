"""The word index: documents of weighted words, widened by the word net, ranked by BM25 with fields (BM25F)."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from c4s.toolbox.search.document import Document
from c4s.toolbox.search.net import word_net
from c4s.toolbox.search.words import stems_of

SATURATION, LENGTH = 1.6, 0.25
"""``k1`` and ``b`` of BM25."""
MISSED = 0.35
"""Share of a score that does not depend on how many of the query's words were met."""


class WordIndex:
    """Ranks documents by the words of a query; only whole words count."""

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

    def scores(self, query: str) -> NDArray[np.float64]:
        """A score for each document, 0 where nothing fits."""
        total, met = np.zeros(self._size), np.zeros(self._size)
        wanted = list(dict.fromkeys(stems_of(query)))
        for stem in wanted:
            if stem in self._posting:
                which, values = self._posting[stem]
                total[which] += values
                met[which] += 1
        return total * (MISSED + (1 - MISSED) * met / max(len(wanted), 1))


def _weights(document: Document) -> dict[str, float]:
    """Weight of each stem of a document: the sum over its fields, or what the word net adds, whichever is more."""
    own: dict[str, float] = defaultdict(float)
    added: dict[str, float] = {}
    net = word_net()
    for text, weight in document.named:
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
