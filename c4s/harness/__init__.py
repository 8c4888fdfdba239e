"""Doors to other programs that drive agents or read what agents did: Harbor's task folders, Inspect AI, ATIF."""

__all__ = ["atif", "driven", "harbor", "inspecting", "oracle"]
