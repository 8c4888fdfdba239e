"""The marked prompts of the text scenes (``cases/open190/wording.py``), one file a kind of place."""

from cases.open190.words import historical

WORDS: dict[str, str] = {**historical.WORDS}
"""By scene id."""

__all__ = ["WORDS"]
