"""Progress of a run, read from its folder: it works the same for a run in this process and for one elsewhere."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    SpinnerColumn,
    Task,
    TimeElapsedColumn,
)
from rich.text import Text

from c4s.cli.output import progress_console, tell
from c4s.names import shown
from c4s.run.plan import Trial

INTERVAL_S = 0.5
PLAIN_INTERVAL_S = 10.0
SIGN_OF_LIFE_S = 60.0


class _Words(ProgressColumn):
    """What a task is doing: its words as text, no markup."""

    def render(self, task: Task) -> Text:
        return Text(shown(task.description))


def bars() -> Progress:
    """A progress display with a count and the time gone by."""
    return Progress(
        SpinnerColumn(),
        _Words(),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=progress_console,
        transient=False,
        disable=not progress_console.is_terminal,
    )


def step_line(message: str) -> None:
    """Where there is no terminal to draw on, a step is a line on standard error."""
    if not progress_console.is_terminal:
        tell(f"  {message.strip()}")


def _newest(trials: list[Trial]) -> str:
    """What the most recently touched unfinished trial is doing."""
    busy = [
        (path.stat().st_mtime, trial.name, path.name)
        for trial in trials
        if trial.folder.root.is_dir()
        for path in trial.folder.root.iterdir()
    ]
    return f"{max(busy)[1]}" if busy else "starting the engine slots"


@contextmanager
def watch(trials: list[Trial], done: set[Path], stored: list[Path]) -> Iterator[None]:
    """Show how many of the outcome files exist, until the block ends.

    ``stored`` are the outcome files of ``trials`` in order; ``done`` those that existed before.
    """
    stop = threading.Event()
    interactive = progress_console.is_terminal

    def count() -> int:
        return sum(path.is_file() for path in stored)

    def follow(progress: Progress) -> None:
        task = progress.add_task("agents and verifiers", total=len(stored), completed=len(done))
        while not stop.wait(INTERVAL_S):
            finished = count()
            pending = [trial for trial, path in zip(trials, stored, strict=True) if not path.is_file()]
            progress.update(task, completed=finished, description=f"running  {_newest(pending):42.42}")
        progress.update(task, completed=count(), description=f"{'trials scored and stored':51}")

    def print_lines() -> None:
        shown, silent_s = -1, 0.0
        while not stop.wait(PLAIN_INTERVAL_S):
            finished = count()
            silent_s += PLAIN_INTERVAL_S
            if finished != shown or silent_s >= SIGN_OF_LIFE_S:
                tell(f"  {finished} of {len(stored)} trials stored")
                shown, silent_s = finished, 0.0

    if interactive:
        with bars() as progress:
            thread = threading.Thread(target=follow, args=(progress,), daemon=True)
            thread.start()
            try:
                yield
            finally:
                stop.set()
                thread.join()
        return
    thread = threading.Thread(target=print_lines, daemon=True)
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()
    tell(f"  {count()} of {len(stored)} trials stored")
