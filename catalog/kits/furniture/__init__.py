"""Furniture of rooms: seats, tables, beds, shelves, cupboards, counters. Fronts look to +Y."""

from catalog.kits.furniture import (
    baths,
    beds,
    care,
    displays,
    frames,
    kitchens,
    music,
    seats,
    services,
    shelves,
    tables,
)

__all__ = ["baths", "beds", "care", "displays", "frames", "kitchens", "music", "seats", "services", "shelves", "tables"]
