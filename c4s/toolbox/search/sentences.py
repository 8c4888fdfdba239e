"""The sentence model: texts become vectors whose cosine says how near their meanings are.

The model is all-MiniLM-L6-v2 (sentence-transformers, Apache-2.0): six BERT layers, the mean of the last one. A package
carries its weights (``c4s.weights``), which are mapped and not copied; what it computes is here, in NumPy, and the
package's own code is not run.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from functools import lru_cache
from itertools import groupby
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf
from threadpoolctl import ThreadpoolController

from c4s.toolbox.search.pieces import Pieces
from c4s.weights import model_folder

LAYERS, HEADS, WIDTH = 6, 12, 384
EPSILON = 1e-12
MOST_AT_ONCE = 4096
"""Pieces that go through the layers together."""

Vectors = NDArray[np.float32]


class SentenceModel:
    """The model over its mapped weights."""

    def __init__(self, folder: Path) -> None:
        self._pieces = Pieces((folder / "vocab.txt").read_text(encoding="utf-8").splitlines())
        self._weights = _mapped(folder / "model.safetensors")
        self._threads = ThreadpoolController()
        """One thread multiplies: several wait for each other on a busy machine, for as long as other work takes."""

    def vectors(self, texts: Sequence[str]) -> Vectors:
        """A unit vector for each text, in their order."""
        found = np.zeros((len(texts), WIDTH), np.float32)
        numbers = [self._pieces.numbers(text) for text in texts]
        order = sorted(range(len(texts)), key=lambda index: len(numbers[index]))
        with self._threads.limit(limits=1):
            for length, group in groupby(order, key=lambda index: len(numbers[index])):
                same = list(group)
                step = max(1, MOST_AT_ONCE // length)
                for start in range(0, len(same), step):
                    part = same[start : start + step]
                    found[part] = self._mean(np.array([numbers[index] for index in part]))
        return found

    def _mean(self, numbers: NDArray[np.int64]) -> Vectors:
        weights = self._weights
        count, length = numbers.shape
        x = weights["embeddings.word_embeddings.weight"][numbers]
        x = x + weights["embeddings.position_embeddings.weight"][:length]
        x = self._norm(x + weights["embeddings.token_type_embeddings.weight"][0], "embeddings.LayerNorm")
        for layer in range(LAYERS):
            name = f"encoder.layer.{layer}"
            query, key, value = (
                self._dense(x, f"{name}.attention.self.{role}")
                .reshape(count, length, HEADS, WIDTH // HEADS)
                .transpose(0, 2, 1, 3)
                for role in ("query", "key", "value")
            )
            share = query @ key.transpose(0, 1, 3, 2) / np.float32(np.sqrt(WIDTH // HEADS))
            share = np.exp(share - share.max(axis=-1, keepdims=True))
            mixed = (share / share.sum(axis=-1, keepdims=True)) @ value
            mixed = mixed.transpose(0, 2, 1, 3).reshape(count, length, WIDTH)
            attended = self._dense(mixed, f"{name}.attention.output.dense")
            x = self._norm(x + attended, f"{name}.attention.output.LayerNorm")
            inner = self._dense(x, f"{name}.intermediate.dense")
            inner = inner * np.float32(0.5) * (1 + erf(inner / np.float32(np.sqrt(2))))
            x = self._norm(x + self._dense(inner, f"{name}.output.dense"), f"{name}.output.LayerNorm")
        mean: Vectors = x.mean(axis=1)
        mean /= np.linalg.norm(mean, axis=1, keepdims=True)
        return mean

    def _dense(self, x: Vectors, name: str) -> Vectors:
        flat = x.reshape(-1, x.shape[-1]) @ self._weights[f"{name}.weight"].T + self._weights[f"{name}.bias"]
        shaped: Vectors = flat.reshape(*x.shape[:-1], -1)
        return shaped

    def _norm(self, x: Vectors, name: str) -> Vectors:
        centred = x - x.mean(axis=-1, keepdims=True)
        spread = np.sqrt((centred * centred).mean(axis=-1, keepdims=True) + np.float32(EPSILON))
        scaled: Vectors = centred / spread * self._weights[f"{name}.weight"] + self._weights[f"{name}.bias"]
        return scaled


def _mapped(file: Path) -> dict[str, Vectors]:
    """The arrays of a safetensors file: the length of the header (8 bytes), the header (JSON), the values."""
    with file.open("rb") as opened:
        length = int.from_bytes(opened.read(8), "little")
        header = json.loads(opened.read(length))
    values = np.memmap(file, np.uint8, "r", offset=8 + length)
    return {
        name: values[slice(*told["data_offsets"])].view(np.float32).reshape(told["shape"])
        for name, told in header.items()
        if name != "__metadata__" and told["dtype"] == "F32"
    }


@lru_cache(maxsize=1)
def sentence_model() -> SentenceModel:
    """The sentence model, opened when it is first asked for."""
    return SentenceModel(model_folder())
