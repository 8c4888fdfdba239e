"""The meaning index: how near a query's meaning is to what a thing is, is called and is for (cosines of vectors)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from c4s.toolbox.search.document import Document
from c4s.toolbox.search.kept import kept_vectors
from c4s.toolbox.search.sentences import sentence_model

TERM = 0.5
"""Weight of a document's nearest term beside its line."""


def vectors_of(documents: Sequence[Document]) -> dict[str, NDArray[np.float32]]:
    """The unit vectors of all lines and terms of documents, by their text; kept on disk for the next time."""
    texts = sorted({text for document in documents for text in (document.line, *document.terms)})
    return dict(zip(texts, kept_vectors(texts), strict=True))


class MeaningIndex:
    """Ranks documents by meaning. ``vectors`` holds every line and term of theirs."""

    def __init__(self, documents: Sequence[Document], vectors: dict[str, NDArray[np.float32]]) -> None:
        terms = [document.terms for document in documents]
        self._lines = np.array([vectors[document.line] for document in documents])
        self._terms = np.array([vectors[term] for row in terms for term in row])
        self._starts = np.cumsum([0] + [len(row) for row in terms[:-1]])

    def scores(self, query: str) -> NDArray[np.float64]:
        """A score for each document, at most ``1 + TERM``."""
        vector = sentence_model().vectors([query])[0]
        nearest = np.maximum.reduceat(self._terms @ vector, self._starts)
        scores: NDArray[np.float64] = (self._lines @ vector + TERM * nearest).astype(np.float64)
        return scores
