"""Reaching a store over a network: what fails is tried again for a while, and told in one line."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from c4s.errors import MachineryFault


class StoreFault(MachineryFault):
    """The store is not reached, or refuses."""


@contextmanager
def reached(name: str) -> Iterator[None]:
    """The block speaks to the store: what its library raises becomes one ``StoreFault``."""
    try:
        yield
    except MachineryFault:
        raise
    except Exception as error:
        raise StoreFault(
            f"the store does not do what is asked: {type(error).__name__}: {error}",
            where=name,
            todo="see that it runs and that its keys are set, then run the same command again",
        ) from error
