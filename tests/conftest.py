"""Properties are judged by their outcome: the time that one example takes depends on the machine."""

from __future__ import annotations

from hypothesis import HealthCheck, settings

settings.register_profile("c4s", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("c4s")
