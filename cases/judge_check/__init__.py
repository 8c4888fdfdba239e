"""Scenes, edits and claims of known truth, to check judges by (``c4s judge check``)."""
