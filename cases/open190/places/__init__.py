"""The 50 places: rooms and places outside, which are repaired, and those that texts ask for."""

from cases.open190.places import outside, rooms, texts

__all__ = ["outside", "rooms", "texts"]
