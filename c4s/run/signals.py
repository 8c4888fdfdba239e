"""What Ctrl-C and SIGTERM do to a run: the first lets what is in work end, the second ends all at once."""

from __future__ import annotations

import asyncio
import signal
from collections.abc import Iterator
from contextlib import contextmanager

from c4s.run.headroom import print_line
from c4s.run.overseer import Overseer, signalled

TERM_S = 25.0
"""How long attempts in work may go on after SIGTERM: service managers kill after 30 s or more."""
SIGNALS = {signal.SIGINT: "Ctrl-C", signal.SIGTERM: "SIGTERM"}


@contextmanager
def ending_in_order(overseer: Overseer, term_s: float = TERM_S) -> Iterator[None]:
    """Around what works on a run, in its event loop. ``KeyboardInterrupt`` where it is ended at once."""
    loop, task = asyncio.get_running_loop(), asyncio.current_task()
    at_once: list[asyncio.TimerHandle] = []
    ended = False

    def end() -> None:
        nonlocal ended
        ended = True
        if task is not None:
            task.cancel()

    def asked(number: signal.Signals) -> None:
        if at_once or (overseer.stopped is not None and overseer.stopped.guard == "signal"):
            end()
            return
        more = f"; in {term_s:.0f} s it is ended" if number == signal.SIGTERM else ""
        overseer.stop(signalled(SIGNALS[number]))
        print_line(f"Ctrl-C (or SIGTERM) once more ends it at once{more}")
        if number == signal.SIGTERM:
            at_once.append(loop.call_later(term_s, end))

    before = {number: signal.getsignal(number) for number in SIGNALS}
    for number in SIGNALS:
        loop.add_signal_handler(number, asked, number)
    try:
        yield
    except asyncio.CancelledError:
        if ended:
            raise KeyboardInterrupt from None
        raise
    finally:
        for timer in at_once:
            timer.cancel()
        for number, handler in before.items():
            loop.remove_signal_handler(number)
            signal.signal(number, handler)
