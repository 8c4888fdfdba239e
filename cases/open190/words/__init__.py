"""The marked prompts of the text scenes (``cases/open190/wording.py``), one file a kind of place."""

from cases.open190.words import fantasy, historical, homes, transit, works

WORDS: dict[str, str] = {**historical.WORDS, **fantasy.WORDS, **transit.WORDS, **works.WORDS, **homes.WORDS}
"""By scene id."""

__all__ = ["WORDS"]
