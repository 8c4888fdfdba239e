"""Small things that stand on others: dishes, food, books, lamps, plants, machines of a desk, and floor lamps."""

from catalog.kits.small import boards, categories, decor, desks, lamps, packages, tableware

__all__ = ["boards", "categories", "decor", "desks", "lamps", "packages", "tableware"]
