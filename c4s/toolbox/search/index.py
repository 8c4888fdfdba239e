"""The search index: words and meaning together."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from c4s.toolbox.search.document import Document
from c4s.toolbox.search.meaning_index import TERM, MeaningIndex, vectors_of
from c4s.toolbox.search.word_index import WordIndex
from c4s.toolbox.search.words import stems_of

WORDS = 0.4
"""Weight of the words' score beside the meaning's."""
HALF = 1.0
"""A score of words that counts half of the most that words can give."""
FITS = 0.5
"""Share of the best score from which on a document fits a query."""
PLACES = 4
"""Decimals of a score: the last bits of a cosine differ between processors."""


class Index:
    """Ranks documents for a query. ``family`` holds documents whose vectors are kept together (those of one pack)."""

    def __init__(self, documents: Sequence[Document], families: Sequence[Sequence[Document]]) -> None:
        vectors: dict[str, NDArray[np.float32]] = {}
        for family in families:
            vectors |= vectors_of(family)
        self._size = len(documents)
        self._words = WordIndex(documents)
        self._meaning = MeaningIndex(documents, vectors) if documents else None

    def scores(self, query: str) -> NDArray[np.float64]:
        """A score in [0, 1] for each document: 0 where it does not fit, or the query has no word that says anything."""
        if self._meaning is None or not stems_of(query):
            return np.zeros(self._size)
        words = self._words.scores(query)
        total = WORDS * words / (words + HALF) + self._meaning.scores(query)
        scores = np.round(np.clip(total, 0, None) / (WORDS + 1 + TERM), PLACES)
        return np.where(scores >= FITS * scores.max(), scores, 0.0)
