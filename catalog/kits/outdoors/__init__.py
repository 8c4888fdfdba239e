"""Street furniture, fences, gates, market stalls, playgrounds, ruins and statues."""

from catalog.kits.outdoors import carts, categories, fences, markets, monuments, play, ruins, streets

__all__ = ["carts", "categories", "fences", "markets", "monuments", "play", "ruins", "streets"]
