"""The one table of a trial's stages: what each occupies while it runs, and where it is ended.

A stage over its limit is ended with all its children. One that reads nothing but what the agent sent and what is
trusted runs into a limit because of the scene: it is repeated once in a fresh worker, and ends as the agent's outcome
(``c4s.run.trial``). Any other is a fault of the machinery.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from c4s.errors import AgentFault

Stage = Literal["attempt", "integrity", "look", "judge", "verify", "score", "persist"]
Kind = Literal["engine", "processor", "request"]
"""What limits a stage: an engine process, a processor, or an open request to a model judge."""


@dataclass(frozen=True)
class Limit:
    """``seconds`` of wall time, and bytes of memory of the worker process (its engine has limits of its own)."""

    kind: Kind
    seconds: float
    of_scene: bool = False
    """Whether only the scene can be why it takes longer."""
    memory_bytes: int = 4 << 30


LIMITS: Final[dict[Stage, Limit]] = {
    "attempt": Limit("engine", 600.0),
    "integrity": Limit("engine", 900.0, of_scene=True),
    "look": Limit("engine", 900.0, of_scene=True),
    "judge": Limit("processor", 900.0, of_scene=True),
    "verify": Limit("processor", 600.0, of_scene=True),
    "score": Limit("processor", 300.0),
    "persist": Limit("processor", 600.0),
}
"""An attempt's seconds count from the end of its wall budget: engine start, and the grace that a client has to stop."""
ONLINE_JUDGE: Final = Limit("request", 3600.0)
"""The stage ``judge`` where the judge asks a model over a network."""


class SceneTooLarge(AgentFault):
    """The scene drove a stage over its limits, and did so again in a fresh worker. An outcome, not a fault."""
