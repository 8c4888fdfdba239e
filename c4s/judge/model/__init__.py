"""A vision model as judge: the upper rungs of the evidence ladder, the overview and paired views, with its client."""

__all__ = ["endpoints", "judging", "prompts", "repeating", "version"]
