"""jsonschema as the tools use it: without the grammar of IRIs, which takes a second to make and which no tool names.

jsonschema loads it with itself where it is installed, and does without where it is not.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

_GRAMMAR = "rfc3987_syntax"


@contextmanager
def _not_installed(module: str) -> Iterator[None]:
    """As if a module that nobody has loaded yet were not there."""
    if module in sys.modules:
        yield
        return
    sys.modules[module] = None  # type: ignore[assignment]
    try:
        yield
    finally:
        del sys.modules[module]


with _not_installed(_GRAMMAR):
    from jsonschema import Draft202012Validator, ValidationError

__all__ = ["Draft202012Validator", "ValidationError"]
