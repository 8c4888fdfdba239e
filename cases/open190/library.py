"""All scenes, by importing the modules that lay them out."""

from cases.open190 import indoor, outdoor, texts_new, texts_old
from cases.open190.scenes import SCENES

LAID_OUT = (indoor, outdoor, texts_old, texts_new)

__all__ = ["LAID_OUT", "SCENES"]
