"""Which judge it is: the code that it decides by."""

from __future__ import annotations

from c4s.records.version import code_version

DECIDE = ("judge/rule", "judge/paired", "semantics", "protocol", "geometry")
"""Folders of ``c4s`` whose sources decide what the rule judge says."""


def rule_version() -> str:
    """Changes with any source or word list that the rule judge decides by."""
    return code_version(*DECIDE)
