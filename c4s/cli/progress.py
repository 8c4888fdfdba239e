"""Progress of builds: a bar with a count, or lines where there is no terminal."""

from __future__ import annotations

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

from c4s.cli.output import progress_console
from c4s.names import shown
from c4s.stderr import tell


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
