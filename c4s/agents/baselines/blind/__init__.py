"""Baseline ``blind``: every trick we know by which a repair can be guessed without looking at a picture."""

from c4s.agents.baselines.blind.guess import Guess, chosen
from c4s.agents.baselines.blind.scene import SeenActor, SeenLevel
from c4s.agents.baselines.blind.tricks import guesses

__all__ = ["Guess", "SeenActor", "SeenLevel", "chosen", "guesses"]
