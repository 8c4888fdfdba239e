"""Vehicles on wheels and rails, boats, and aircraft. Noses point to +X unless told otherwise."""

from catalog.kits.vehicles import boats, cars, carts, categories, planes, quays, tracks, trains, wheels

__all__ = ["boats", "cars", "carts", "categories", "planes", "quays", "tracks", "trains", "wheels"]
