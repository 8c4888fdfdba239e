"""Ground, water, plants, rocks and animals."""

from catalog.kits.nature import animals, categories, crops, ground, hills, shrubs, trees, woodland

__all__ = ["animals", "categories", "crops", "ground", "hills", "shrubs", "trees", "woodland"]
