"""Word pieces: how the sentence model reads a text (lower case, no accents, the longest known piece first)."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence

MOST_PIECES = 96
"""Pieces of a text that are read; what stands behind them is left out."""
LONGEST_WORD = 40
_START, _END, _UNKNOWN = "[CLS]", "[SEP]", "[UNK]"
_PART = re.compile(r"[^\W_]+|[^\w\s]|_")


class Pieces:
    """The vocabulary of a model; a piece that goes on a word begins with ``##``."""

    def __init__(self, vocabulary: Sequence[str]) -> None:
        self._number = {piece: number for number, piece in enumerate(vocabulary)}

    def numbers(self, text: str) -> list[int]:
        """Numbers of a text's pieces between the model's marks of start and end."""
        flat = "".join(
            sign for sign in unicodedata.normalize("NFD", text.lower()) if unicodedata.category(sign) != "Mn"
        )
        pieces = [piece for word in _PART.findall(flat) for piece in self._word(word)]
        return [self._number[piece] for piece in (_START, *pieces[: MOST_PIECES - 2], _END)]

    def _word(self, word: str) -> list[str]:
        found: list[str] = []
        at = 0
        while at < len(word):
            lead = "##" if at else ""
            end = next((end for end in range(len(word), at, -1) if lead + word[at:end] in self._number), at)
            if end == at or len(word) > LONGEST_WORD:
                return [_UNKNOWN]
            found.append(lead + word[at:end])
            at = end
        return found
