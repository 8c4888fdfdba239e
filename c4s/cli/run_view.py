"""A run in the terminal: a view that draws itself anew, lines where there is no terminal, JSON for programs."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console, Group, RenderableType
from rich.live import Live
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from c4s.cli.output import progress_console
from c4s.errors import BadInput
from c4s.names import shown
from c4s.records.progress import Snapshot
from c4s.run.progress import Progress
from c4s.stderr import as_json, tell
from reports.text import clock, number, span

INTERVAL_S = 0.5
PLAIN_INTERVAL_S = 10.0
SIGN_OF_LIFE_S = 60.0
ROWS_KEPT = 12
"""Lines of the terminal that are kept from the stages in work."""
STYLES = {"running": "green", "done": "green", "paused": "yellow", "stopping": "yellow", "stopped": "red"}


def line_of(now: Snapshot) -> str:
    """The run in one line: counts, cost, estimated end, what stops it."""
    told = [f"{now.done} of {now.planned} trials done"]
    if _in_work(now):
        told.append(f"{_in_work(now)} in work")
    if now.pending:
        told.append(f"{now.pending} pending")
    if cost := _cost(now):
        told.append(cost)
    if now.left_s is not None and now.done < now.planned:
        told.append(f"about {span(now.left_s)} left")
    if now.state not in ("running", "done"):
        told.append(f"{now.state}{f': {now.why}' if now.why else ''}")
    return ", ".join(told)


def view(now: Snapshot, height: int) -> RenderableType:
    """The run as a screen of so many lines."""
    head = Text.assemble((shown(now.run_id), "bold"), "  ", (now.state, STYLES.get(now.state, "dim")))
    if now.why:
        head.append(shown(f"  {now.why}"), "yellow")
    parts: list[RenderableType] = [head, _bar(now), _facts(now), Text(""), _standings(now)]
    if now.troubles:
        parts += [Text(""), *(_trouble(row.error, row.trials, row.line, row.faults) for row in now.troubles[:3])]
    if now.running:
        room = max(3, height - ROWS_KEPT - len(now.standings) - 3 * min(3, len(now.troubles)))
        parts += [Text(""), _running(now, room)]
    return Group(*parts)


def _in_work(now: Snapshot) -> int:
    return now.planned - now.done - now.pending - now.waiting


def _cost(now: Snapshot) -> str:
    if now.spent_usd is None:
        return ""
    limit = "" if now.spend_limit_usd is None else f" of ${now.spend_limit_usd:.2f}"
    return f"${now.spent_usd:.2f}{limit}"


def _bar(now: Snapshot) -> RenderableType:
    row = Table.grid(padding=(0, 1))
    row.add_row(
        ProgressBar(max(1, now.planned), now.done, 48, complete_style="green", finished_style="green"),
        Text(f"{now.done}/{now.planned} trials", "bold"),
        Text(f"{_in_work(now)} in work"),
        Text(f"{now.waiting} waiting"),
        Text(f"{now.pending} pending", "red" if now.pending else "dim"),
    )
    return row


def _facts(now: Snapshot) -> Text:
    slots = ", ".join(f"{slot.kind} {slot.busy}/{slot.count}" for slot in now.slots)
    told = [f"slots: {slots}"] if slots else []
    told += [cost] if (cost := _cost(now)) else []
    if now.left_s is not None:
        told.append(f"about {span(now.left_s)} left, to {clock(now.time + now.left_s)}")
    if now.deadline is not None:
        told.append(f"deadline {clock(now.deadline)}")
    return Text("   ".join(told), "dim")


def _table(*columns: str, right: tuple[str, ...] = ()) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold dim", padding=(0, 2, 0, 0))
    for column in columns:
        table.add_column(column, justify="right" if column in right else "left", no_wrap=True)
    return table


def _standings(now: Snapshot) -> RenderableType:
    table = _table(
        "agent", "done", "pending", "score so far", "cost", right=("done", "pending", "score so far", "cost")
    )
    for row in now.standings:
        table.add_row(
            Text(shown(row.configuration)),
            f"{row.done}/{row.planned}",
            Text(str(row.pending), "red") if row.pending else Text("–", "dim"),
            number(row.mean_score),
            "–" if row.cost_usd is None else f"${row.cost_usd:.2f}",
        )
    return table


def _trouble(error: str, trials: int, line: str, faults: str) -> RenderableType:
    text = Text(f"{trials} pending with {shown(error)}: ", "red", no_wrap=True, overflow="ellipsis")
    text.append(shown(line), "default")
    return Group(text, Text(shown(f"  {faults}"), "dim", no_wrap=True, overflow="ellipsis"))


def _running(now: Snapshot, room: int) -> RenderableType:
    table = _table("in work", "case", "stage", "calls", "time", "of", right=("calls", "time", "of"))
    for row in now.running[:room]:
        repeat = f" r{row.repeat}" if row.repeat > 1 else ""
        table.add_row(
            Text(shown(row.configuration)),
            Text(shown(f"{row.case}{repeat}"), overflow="ellipsis"),
            Text(shown(row.stage) + (f" {row.attempt}" if row.attempt else "")),
            "" if row.calls_budget is None else f"{row.calls or 0}/{row.calls_budget}",
            span(row.seconds),
            "" if row.wall_budget_s is None else span(row.wall_budget_s),
        )
    if len(now.running) > room:
        table.add_row(Text(f"and {len(now.running) - room} more", "dim"))
    return table


@contextmanager
def drawn(progress: Progress, on: Console = progress_console) -> Iterator[None]:
    """Show a run until the block ends: a view that draws itself anew, or lines where there is no terminal."""
    stop = threading.Event()
    show = _draw if on.is_terminal and not as_json() else _print_lines

    def follow() -> None:
        try:
            show(progress, on, stop)
        except BadInput as error:
            tell(f"  the run cannot be shown any more: {error.line()}")

    thread = threading.Thread(target=follow, name="view", daemon=True)
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()


def _draw(progress: Progress, on: Console, stop: threading.Event) -> None:
    with Live(console=on, auto_refresh=False, redirect_stdout=False) as live:
        while not stop.wait(INTERVAL_S):
            live.update(view(progress.read(), on.height), refresh=True)
        live.update(view(progress.read(), on.height), refresh=True)


def _print_lines(progress: Progress, on: Console, stop: threading.Event) -> None:
    counted, silent_s, last = (-1, -1), 0.0, ""
    while not stop.wait(PLAIN_INTERVAL_S):
        now = progress.read()
        silent_s += PLAIN_INTERVAL_S
        if (now.done, now.pending) != counted or silent_s >= SIGN_OF_LIFE_S:
            last = line_of(now)
            tell(f"  {last}")
            counted, silent_s = (now.done, now.pending), 0.0
    if (line := line_of(progress.read())) != last:
        tell(f"  {line}")
