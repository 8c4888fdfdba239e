"""How a tool says no."""

from __future__ import annotations

from c4s.errors import C4SError


class ToolRefused(C4SError):
    """A tool cannot do what was asked. The message goes to the agent; the call counts."""

    exit_code = 1
