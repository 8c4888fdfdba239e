"""Spatial queries of the open level: rays, sweeps and overlaps against collision bodies or triangles."""
