"""All scenes, by importing the modules that lay them out."""

from cases.open190 import indoor, outdoor
from cases.open190.scenes import SCENES

LAID_OUT = (indoor, outdoor)

__all__ = ["LAID_OUT", "SCENES"]
