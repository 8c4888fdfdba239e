"""What ``c4s --version`` prints."""

from __future__ import annotations

from importlib.metadata import version

from c4s.engine import DEFAULT_ENGINE, backend
from c4s.protocol.rules import CASE_POLICY, DEFAULT_POLICY


def versions() -> str:
    """The version of the package, of its own engine, and of how scores are made: a line each."""
    rules = ", ".join(dict.fromkeys(CASE_POLICY.values()))
    return f"c4s {version('c4s')}\nengine {backend(DEFAULT_ENGINE).version}\npolicy {DEFAULT_POLICY} ({rules})"
