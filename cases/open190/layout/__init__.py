"""Layout rules: how things are put into a place without penetration and with support, and what stands how to what.

Cm and degrees. At yaw 0 a front looks to +Y; a row that runs from a to b has the fronts on its left as seen from above
with X to the right and Y up. What finds no room is left out and counted (``left_out``).
"""

from cases.open190.layout.ground import SEABED_CM
from cases.open190.layout.place import StagedPlace
from cases.open190.layout.things import Assets, Box, Item, Pair, Relation

__all__ = ["SEABED_CM", "Assets", "Box", "Item", "Pair", "Relation", "StagedPlace"]
