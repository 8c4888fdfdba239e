"""Houses, towers, halls and other buildings. Fronts look to +Y."""

from catalog.kits.buildings import blocks, castles, halls, houses, landmarks, pavilions, worship

__all__ = ["blocks", "castles", "halls", "houses", "landmarks", "pavilions", "worship"]
