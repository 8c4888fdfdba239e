"""Reaching a store over a network: what fails is tried again for a while, and told in one line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager

from c4s.errors import MachineryFault

_USER = re.compile(
    r"""(?:(?<=//)|(?<![^\s"'(=/]))[^\s"'/]*:(?!//)[^\s"']*@"""  # name:password@, also after //
    r"""|(?<=//)[^\s"'/@]*@"""  # //name@
)


def without_password(text: str) -> str:
    """A text without what stands before the ``@`` of a URL or of a part of one: who may reach the store."""
    return _USER.sub("", text)


class StoreFault(MachineryFault):
    """The store is not reached, or refuses."""


@contextmanager
def reached(name: str, but: tuple[type[Exception], ...] = ()) -> Iterator[None]:
    """The block speaks to the store: what its library raises becomes one ``StoreFault``, without a password in it.

    ``but``: errors that the caller has a better word for.
    """
    try:
        yield
    except MachineryFault:
        raise
    except but:
        raise
    except Exception as error:
        told = without_password(str(error))
        raise StoreFault(
            f"the store does not do what is asked: {type(error).__name__}: {told}",
            where=name,
            todo="see that it runs and that its keys are set, then run the same command again",
        ) from (error if told == str(error) else None)
