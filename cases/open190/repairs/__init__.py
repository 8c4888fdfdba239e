"""Repairs of the source scenes: which are wanted, what can be changed, drafts, and units that are written."""
