"""A client that starts c4s itself, as a tool server on standard input and output."""

from __future__ import annotations

import threading

import anyio

from c4s.agents.base import AgentContext, AgentReport
from c4s.toolbox.stdio import serve_stdio


class StdioAgent:
    """Whoever is at the other end of standard input and output; done once that is closed."""

    def run(self, context: AgentContext) -> AgentReport:
        """Answer until the client leaves, also after the run has ended."""
        over = threading.Event()
        watch = threading.Thread(target=_note, args=(context, over), name="stdio-run", daemon=True)
        watch.start()
        anyio.run(serve_stdio, context.endpoint, over)
        return AgentReport(message="the client closed the connection")


def _note(context: AgentContext, over: threading.Event) -> None:
    """Set an event once the run takes no more calls."""
    while not context.stopped(1.0):
        continue
    over.set()
