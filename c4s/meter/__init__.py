"""The pass-through to models: keys, usage, prices, the spending limit."""

__all__ = ["endpoints", "meter", "prices", "record", "run", "spending", "wire"]
