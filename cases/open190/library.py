"""All scenes, by importing the modules that lay them out."""

from cases.open190 import bygone, indoor, outdoor, today
from cases.open190.scenes import SCENES

LAID_OUT = (indoor, outdoor, bygone, today)

__all__ = ["LAID_OUT", "SCENES"]
