"""The store that the environment names."""

from __future__ import annotations

import os
from functools import cache

from c4s.run.store.base import STORE, SharedFolder, Store


def open_store() -> Store:
    """The store of ``C4S_STORE``, else ``C4S_HOME`` as a folder that is shared.

    Raises:
        BadInput: what is named is no URL of a store that can be used.
        MachineryFault: the store does not answer.
    """
    url = os.environ.get(STORE, "")
    return _object_store(url) if url else SharedFolder()


@cache
def _object_store(url: str) -> Store:
    from c4s.run.store.objects import ObjectStore

    return ObjectStore(url)
