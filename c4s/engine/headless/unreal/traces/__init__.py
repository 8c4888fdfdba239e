"""Traces, sweeps and overlaps as scripts call them; the geometry is in ``c4s.engine.headless.queries``."""
