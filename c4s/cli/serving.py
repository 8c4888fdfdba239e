"""A trial whose work is done by a client from outside: its gateway is told, its calls are shown, Ctrl-C ends them."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any

from c4s.agents.connecting import ways
from c4s.agents.outside import OUTSIDE, Connection, DeskFolder
from c4s.cli.live import LiveView, follow
from c4s.cli.output import console, print_json, say
from c4s.cli.trying import Try, say_ending
from c4s.loopback import listener
from c4s.records.folder import AttemptFolder
from c4s.records.plan import Configuration
from c4s.records.score import TrialScore
from c4s.records.suite import Budget, SuiteFolder


def prepare(
    suite: Path, case: str, *, port: int, after_save_s: float, harness: str | None, policy: str, judge: str, engine: str
) -> Try:
    """Check all that is asked for, and make the folder. ``BadInput`` before anything is made."""
    chosen = outside(port=port, after_save_s=after_save_s, harness=harness)
    return Try.prepare(chosen, suite, case, policy=policy, judge=judge, engine=engine)


def outside(*, port: int, after_save_s: float, harness: str | None) -> Configuration:
    """The configuration of a client from outside. ``BadInput`` where its port is taken."""
    if port:
        listener(port).close()
    options = {"after_save_s": after_save_s, **({"port": port} if port else {})}
    return Configuration(name=OUTSIDE, client=OUTSIDE, options=options, harness=harness)


def run(tried: Try, *, after_save_s: float, json_lines: bool) -> TrialScore:
    """Open the gateway, show what comes, and score what was saved last; there is one attempt."""
    budget = SuiteFolder(tried.suite).agent_case(tried.trial.case.alias).budget

    @contextmanager
    def watching(attempt: Path) -> Iterator[None]:
        with attended(attempt, budget, after_save_s=after_save_s, json_lines=json_lines):
            yield
        if not json_lines:
            say_ending(attempt)

    return tried.run(watching, attempts=1)


@contextmanager
def attended(attempt: Path, budget: Budget, *, after_save_s: float, json_lines: bool) -> Iterator[None]:
    """Tell how to connect once the gateway of an attempt is open, then show its calls; Ctrl-C ends its work."""
    desk, view = DeskFolder(AttemptFolder(attempt).agent), LiveView(console, attempt)

    def opened() -> None:
        connection = Connection.read(desk.connection)
        if json_lines:
            print_json(_plain(connection, budget))
        else:
            _say(connection, budget, after_save_s)

    first = _Once(opened)

    def poll() -> None:
        if desk.connection.is_file():
            first()
        if not json_lines:
            view.poll()

    with _ctrl_c_ends(desk), follow(attempt, poll):
        yield


class _Once:
    """Does a thing the first time that it is called."""

    def __init__(self, what: Callable[[], None]) -> None:
        self._what: Callable[[], None] | None = what

    def __call__(self) -> None:
        if self._what is not None:
            what, self._what = self._what, None
            what()


@contextmanager
def _ctrl_c_ends(desk: DeskFolder) -> Iterator[None]:
    """Ctrl-C ends the work from outside; a second one, or one before the gateway is open, this process."""

    def end(number: int, frame: FrameType | None) -> None:
        if not desk.connection.is_file() or desk.done.is_file():
            raise KeyboardInterrupt
        desk.done.touch()

    before = signal.signal(signal.SIGINT, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _plain(connection: Connection, budget: Budget) -> dict[str, Any]:
    """What programs are told once the gateway is open."""
    connect = {way.client: way.plain() for way in ways(connection.url, connection.token)}
    return connection.plain() | {"budget": budget.plain(), "connect": connect}


def _say(connection: Connection, budget: Budget, after_save: float) -> None:
    """The same for people."""
    say(f"The tools are open at {connection.url}, with the token {connection.token}")
    for way in ways(connection.url, connection.token):
        say("")
        say(way.client, style="bold")
        for line in way.lines():
            say(f"  {line}")
    say("")
    say(f"Give your agent the text of {connection.task}")
    for picture in connection.pictures:
        say(f"and the picture {picture}")
    say(
        f"It may make {budget.tool_calls} calls in {budget.wall_minutes:g} minutes from now. Ctrl-C scores what it "
        f"saved last; so does {after_save:g} s without a call after a save."
    )
