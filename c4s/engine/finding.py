"""What a kind of engine needs of the machine that it runs on."""

from __future__ import annotations

from typing import NamedTuple


class EngineFinding(NamedTuple):
    """One thing that was looked for."""

    what: str
    found: bool
    text: str
    """What it is, or what is missing and what that costs."""
