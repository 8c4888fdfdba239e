"""The pass-through to models: keys, usage, prices, the spending limit."""

__all__ = ["endpoints", "meter", "metered", "prices", "record", "spending", "usage", "wire"]
