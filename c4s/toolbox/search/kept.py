"""Vectors that were computed once: kept under ``C4S_HOME/cache`` by the digest of their texts and of the model."""

from __future__ import annotations

import io
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from c4s.files import digest, write_bytes
from c4s.home import cache_root
from c4s.toolbox.search.sentences import WIDTH, sentence_model
from c4s.weights import WEIGHTS_SHA256


def kept_vectors(texts: Sequence[str]) -> NDArray[np.float32]:
    """A unit vector for each text, from the cache where they are there. Either way they have half precision."""
    place = cache_root() / "meanings" / f"{digest([WEIGHTS_SHA256, *texts])}.npy"
    if place.is_file():
        held: NDArray[np.float16] = np.load(io.BytesIO(place.read_bytes()), allow_pickle=False)
        if held.shape == (len(texts), WIDTH):
            return held.astype(np.float32)
    found = sentence_model().vectors(texts).astype(np.float16)
    file = io.BytesIO()
    np.save(file, found)
    write_bytes(place, file.getvalue())
    return found.astype(np.float32)
