"""Where Embree 4.4.0 keeps the fields of a packet of 16 rays and their hits, in 4-byte words (``rtcore_ray.h``).

A field holds 16 consecutive lanes. Fields marked (int) are 32-bit integers, the others 32-bit floats.
"""

from __future__ import annotations

LANES = 16
ORIGIN = 0
"""x, y, z: three fields of 16 lanes."""
TNEAR = 48
DIRECTION = 64
"""x, y, z."""
TIME = 112
TFAR = 128
"""Distance to the hit; negative after an occlusion query that found something."""
RAY_MASK = 144
"""(int)"""
RAY_ID = 160
"""(int)"""
FLAGS = 176
"""(int)"""
NORMAL = 192
"""x, y, z: geometric normal of the hit in the instance's own axes, not of unit length."""
HIT_U = 240
HIT_V = 256
PRIMITIVE = 272
"""(int)"""
GEOMETRY = 288
"""(int) -1 for a miss."""
INSTANCE = 304
"""(int)"""
RAY_WORDS = 12 * LANES
RAYHIT_WORDS = 21 * LANES
"""With the instance's primitive, the last field of the structure."""

OPAQUE_MASK = 1
TRANSLUCENT_MASK = 2
"""Geometry masks: shadow and ambient occlusion rays see opaque surfaces only."""
