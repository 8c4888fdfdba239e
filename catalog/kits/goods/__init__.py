"""Crates, barrels and sacks; machines, pipes and tanks; tools of trades."""

from catalog.kits.goods import categories, cranes, forges, machines, tanks, vessels, works

__all__ = ["categories", "cranes", "forges", "machines", "tanks", "vessels", "works"]
