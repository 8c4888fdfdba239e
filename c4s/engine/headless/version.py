"""Which engine this is."""

ENGINE_VERSION = "5.6.0-c4s.headless"
"""Version of Unreal whose Python API the headless engine follows, as its scripts read it.

Signatures, results and how results come back are those of 5.6 (``hits.results.layout`` switches how they come back);
the names that 5.8 gave to the same things are there too.
"""
