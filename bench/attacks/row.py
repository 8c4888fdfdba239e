"""A row of the table of attacks, and what a wall looks like from inside."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from c4s.engine.confine.confinement import Backend

Wall = Literal["filter", "files", "limit", "kernel", "pipe", "nothing"]
"""``filter``: the system-call filter. ``files``: mount namespace or Landlock. ``limit``: a resource limit. ``kernel``:
the kernel itself, for want of privileges. ``pipe``: output lies with the host. ``nothing``: the call says that it
worked, and nothing has changed; or what it looks for is not there."""
WALLS: dict[Wall, str] = {
    "filter": r"\[Errno (1|38|95)\]",
    "files": r"\[Errno (1|2|6|13|16|18|20|30)\]",
    "limit": r"MemoryError|\[Errno (11|12|24|27)\]|maximum limit",
    "kernel": r"\[Errno (1|12|22)\]",
    "pipe": r"\[Errno (22|29)\]",
    "nothing": r"^(Nothing|StopIteration|gaierror|URLError)",
}
"""What each wall's refusal reads like (a pattern)."""


@dataclass(frozen=True)
class Attack:
    """An attack that has to raise."""

    name: str
    wall: Wall
    """What is expected to stop it."""
    code: str
    """A Python expression; ``trial.py`` tells its names."""
    known: dict[Backend, str] = field(default_factory=dict)
    """Sandboxes that do not stop it, each with the reason."""


@dataclass(frozen=True)
class AttackResult:
    """What became of an attack in a sandbox."""

    attack: str
    backend: Backend
    expected: str
    """The wall, or the reason for which it is known to get through."""
    failed: bool
    """Whether the attack failed, at the wall that was expected."""
    known: bool
    """Whether it is known to get through here."""
    told: str
