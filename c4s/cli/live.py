"""What an agent is doing, as lines in the terminal, read from the files of its attempt while it works."""

from __future__ import annotations

import io
import json
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.text import Text

from c4s.cli.output import draw
from c4s.errors import BadInput
from c4s.meter.record import sums
from c4s.names import shown
from c4s.records.folder import AttemptFolder

INTERVAL_S = 0.25
THUMBNAIL_COLUMNS = 64
_SHOWN_ARGUMENTS = 72


class _Follower:
    """Reads the whole lines that were appended to a file since the last time."""

    def __init__(self, path: Path) -> None:
        self.path, self.offset = path, 0

    def lines(self) -> list[dict[str, Any]]:
        if not self.path.is_file():
            return []
        with self.path.open("rb") as source:
            source.seek(self.offset)
            data = source.read()
        whole = data[: data.rfind(b"\n") + 1]
        self.offset += len(whole)
        return [json.loads(line) for line in whole.split(b"\n") if line.strip()]


class LiveView:
    """Prints the calls of an attempt as they end."""

    def __init__(self, console: Console, attempt: Path) -> None:
        self.console, self.attempt = console, AttemptFolder(attempt)
        self._calls, self._usage = _Follower(self.attempt.trajectory), _Follower(self.attempt.usage)
        self._requests: list[dict[str, Any]] = []

    def poll(self) -> None:
        """Print what is new."""
        self._requests += self._usage.lines()
        for line in self._calls.lines():
            if line["event"] == "started":
                continue
            draw(self.console, call_line(line, cost_text(self._requests)))
            for image in line.get("images") or []:
                path = self.attempt.images / f"{image['sha256']}.png"
                if path.is_file():
                    draw(self.console, thumbnail(self.console, path))


def cost_text(requests: list[dict[str, Any]]) -> str:
    """Cost so far; empty for an agent without a model, and said to be unknown where it is."""
    if not requests:
        return ""
    cost = sums(requests)["cost_usd"]
    return "cost unknown" if cost is None else f"${cost:.4f}"


def call_line(line: Mapping[str, Any], cost: str) -> Text:
    """One call: number, tool, arguments, how it ended, and the budget left."""
    event, outcome = line["event"], line["outcome"]
    number = f"{line['call']:4d}" if event == "call" else "   –"
    given = ", ".join(
        f"{key}={json.dumps(value, ensure_ascii=False)}" for key, value in (line.get("arguments") or {}).items()
    )
    given = shown(" ".join(given.split()))
    text = Text(f"{number}  ")
    text.append(shown(str(line["tool"])), "bold")
    text.append(f" {given[:_SHOWN_ARGUMENTS]}{'…' if len(given) > _SHOWN_ARGUMENTS else ''}", "dim")
    took = f" {1000 * line['duration_s']:.0f} ms" if "duration_s" in line else ""
    text.append(shown(f"  {outcome}{took}"), "green" if outcome == "ok" else "red")
    if line.get("error"):
        text.append(shown(f"  {' '.join(str(line['error']).split())[:160]}"), "red")
    left = f"{line['tool_calls_left']} calls, {line['seconds_left'] // 60} min {line['seconds_left'] % 60} s left"
    text.append(f"  [{left}{', ' + cost if cost else ''}]", "dim")
    return text


def thumbnail(console: Console, path: Path) -> Text:
    """A picture in half blocks where the terminal has colours, else where its file lies."""
    if not console.is_terminal or console.color_system not in ("256", "truecolor"):
        return Text(shown(f"      picture {path}"), "dim")
    from PIL import Image

    with Image.open(io.BytesIO(path.read_bytes())) as opened:
        width = min(THUMBNAIL_COLUMNS, console.width - 8)
        height = max(2, round(opened.height * width / opened.width) // 2 * 2)
        picture = opened.convert("RGB").resize((width, height), Image.Resampling.BOX)
    pixels = picture.tobytes()

    def colour(x: int, y: int) -> str:
        r, g, b = pixels[3 * (y * width + x) : 3 * (y * width + x) + 3]
        return f"#{r:02x}{g:02x}{b:02x}"

    text = Text()
    for y in range(0, height, 2):
        text.append("      ")
        for x in range(width):
            text.append("▀", f"{colour(x, y)} on {colour(x, y + 1)}")
        text.append("\n")
    return text


@contextmanager
def follow(attempt: Path, poll: Callable[[], None]) -> Iterator[None]:
    """Poll for what is new of an attempt while the block runs, and once more at its end."""
    stop = threading.Event()
    faults: list[BaseException] = []

    def watch() -> None:
        try:
            while not stop.wait(INTERVAL_S):
                poll()
            poll()
        except Exception as fault:
            faults.append(fault)

    thread = threading.Thread(target=watch, name="live-view", daemon=True)
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()
    if faults:
        raise BadInput(f"the attempt's record cannot be read: {faults[0]}", where=str(attempt)) from faults[0]
