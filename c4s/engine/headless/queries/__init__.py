"""Spatial queries of the open level: rays, sweeps and overlaps against collision bodies or triangles."""

__all__ = ["cast", "changes", "channels", "filters", "index", "walkable"]
