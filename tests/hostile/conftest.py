"""The fixture of this folder."""

from prey import prey

__all__ = ["prey"]
