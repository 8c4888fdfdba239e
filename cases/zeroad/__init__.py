"""Maps of the game 0 A.D. as imported scenes, from the archive of its package: meshes, actors, terrain."""

from cases.zeroad.ground import Square
from cases.zeroad.maps import SOFT, read_map

__all__ = ["SOFT", "Square", "read_map"]
