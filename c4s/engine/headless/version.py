"""Which engine this is."""

ENGINE_VERSION = "5.6.0-c4s.headless"
"""Version of the API that the headless engine follows, as its scripts read it."""
