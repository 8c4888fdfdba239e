"""The one table of a trial's stages: what each occupies while it runs, and where it is ended.

A stage over its limit is ended with all its children. Where one fails that reads nothing but what the agent sent and
what is trusted, the scene may be why: it is repeated once in a fresh worker (``c4s.run.pool``), and what that means is
decided by the program of the trial (``c4s.run.trial``).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

Stage = Literal["attempt", "integrity", "look", "judge", "verify", "control", "score", "persist"]
Kind = Literal["engine", "processor", "request"]
"""What limits a stage: an engine process, a processor, or an open request to a model judge."""


@dataclass(frozen=True)
class Limit:
    """``seconds`` of wall time, and bytes of memory of the worker process (its engine has limits of its own)."""

    kind: Kind
    seconds: float
    of_scene: bool = False
    """Whether it reads one scene and what is trusted, so that the scene may be why it fails."""
    memory_bytes: int = 4 << 30


LIMITS: Final[dict[Stage, Limit]] = {
    "attempt": Limit("engine", 600.0),
    "integrity": Limit("engine", 900.0, of_scene=True),
    "look": Limit("engine", 900.0, of_scene=True),
    "judge": Limit("processor", 900.0, of_scene=True),
    "verify": Limit("processor", 600.0, of_scene=True),
    "control": Limit("engine", 1800.0),
    "score": Limit("processor", 300.0),
    "persist": Limit("processor", 600.0),
}
"""An attempt's seconds count from the end of its wall budget: engine start, and the grace that a client has to stop."""
ONLINE_JUDGE: Final = Limit("request", 3600.0)
"""The stage ``judge`` where the judge asks a model over a network."""
