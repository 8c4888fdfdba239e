"""Which engine this is."""

ENGINE_VERSION = "5.6.0-c4s.headless+5.8-names"
"""What the headless engine models, as its scripts read it: the Python API of Unreal 5.6, and names of 5.8.

Signatures, properties and results are those that the stub of 5.6 lists. Of 5.8, which the published benchmark runs, the
names are there that its own scripts are known to use (``ObjectTypeQuery.ECC_*``, ``TraceTypeQuery.ECC_*``,
``HitResult.to_dict``); no stub of 5.8 is public, so what else it changed is not modelled.
"""
