"""Where Embree 4.4.0 keeps the fields of a packet of 8 rays and their hits, in 4-byte words (``rtcore_ray.h``).

A field holds 8 consecutive lanes. Fields marked (int) are 32-bit integers, the others 32-bit floats.
"""

from __future__ import annotations

LANES = 8
"""Rays a packet: what AVX2 traces natively. (Packets of 16 are then split by Embree, which also copies hit fields that
an occlusion query's shorter structure does not have.)"""
ORIGIN = 0 * LANES
"""x, y, z: three fields."""
TNEAR = 3 * LANES
DIRECTION = 4 * LANES
"""x, y, z."""
TIME = 7 * LANES
TFAR = 8 * LANES
"""Distance to the hit; negative after an occlusion query that found something."""
RAY_MASK = 9 * LANES
"""(int)"""
RAY_ID = 10 * LANES
"""(int)"""
FLAGS = 11 * LANES
"""(int)"""
NORMAL = 12 * LANES
"""x, y, z: geometric normal of the hit in the instance's own axes, not of unit length."""
HIT_U = 15 * LANES
HIT_V = 16 * LANES
PRIMITIVE = 17 * LANES
"""(int)"""
GEOMETRY = 18 * LANES
"""(int) -1 for a miss."""
INSTANCE = 19 * LANES
"""(int)"""
RAY_WORDS = 12 * LANES
RAYHIT_WORDS = 21 * LANES
"""With the instance's primitive, the last field of the structure."""

OPAQUE_MASK = 1
TRANSLUCENT_MASK = 2
"""Geometry masks: shadow and ambient occlusion rays see opaque surfaces only."""
