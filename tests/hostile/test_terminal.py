"""What anybody calls something is shown as text: no escape sequence, direction override or markup reaches a reader."""

from __future__ import annotations

import io
import json
import os
import pty
import re
import subprocess
import sys
from pathlib import Path

import pytest
from called import call
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console
from rich.text import Text

from c4s.cli.live import call_line
from c4s.cli.output import draw, print_json, print_table, say
from c4s.cli.progress import bars
from c4s.names import shown
from c4s.stderr import tell
from reports.frame import environment
from warehouse.database import rebuild

ATTACK = (
    "\x1b]0;owned\x07\x1b[2J\x1b[31m\x9b31m\x9d0;x\x9c\x1b]8;;http://evil\x1b\\click\x1b]8;;\x1b\\\r\b\x7f"
    "\u202egnp.exe\u2066\u200b\u2028\udcff[red]R[/red][link=http://evil]l[/link][/]"
)
WORDS = ("click", "gnp.exe", "[red]R[/red]", "[link=http://evil]l[/link][/]")
OWN_STYLE = re.compile(r"\x1b\[[0-9;?]*[mhlKGA]")
"""What the terminal library itself writes: styles, and the cursor of a progress bar."""


def sound(told: str, words: tuple[str, ...] = WORDS) -> None:
    """Nothing of the attack works in this output, and its words can be read."""
    assert not {one for one in told if not one.isprintable()} - {"\n"}, ascii(told)
    assert all(word in told for word in words), ascii(told)


@given(st.text(), st.sampled_from(["", "\n", "\n\t"]))
def test_what_is_shown_is_visible_and_ordinary_text_is_itself(text: str, keep: str) -> None:
    made = shown(text, keep)
    assert all(one.isprintable() or one in keep or one.isspace() for one in made)
    assert not set(made) & set("\x1b\x9b\r\x07\x85\u2028\u202e") and ("\n" in keep or "\n" not in made)
    made.encode()
    if text.isprintable():
        assert made == text


def test_lines_tables_and_errors(capsys: pytest.CaptureFixture[str]) -> None:
    say(ATTACK)
    say(ATTACK, style="dim")
    tell(ATTACK)
    print_table([ATTACK, "b"], [[ATTACK, 1]], title=ATTACK)
    told = capsys.readouterr()
    sound(told.err)
    assert not {one for one in told.out if not one.isprintable()} - {"\n"}, ascii(told.out)
    assert "\n" not in told.err[:-1]


def test_json_says_it_exactly_and_in_visible_characters(capsys: pytest.CaptureFixture[str]) -> None:
    value = {ATTACK: [ATTACK, "Straße \U0001f600 \U000e0001"]}
    print_json(value)
    told = capsys.readouterr().out
    assert told[:-1].isprintable() and "Straße" in told
    assert json.loads(told) == value


def test_the_live_view_and_the_progress_bar() -> None:
    line = {
        "event": "call",
        "outcome": ATTACK,
        "call": 1,
        "tool": ATTACK,
        "arguments": {ATTACK: "x", "b": ATTACK},
        "error": ATTACK,
        "tool_calls_left": 1,
        "seconds_left": 1,
    }
    assert call_line(line, "").plain.isprintable()
    out = io.StringIO()
    draw(Console(file=out, force_terminal=True, color_system="truecolor", width=4000), call_line(line, ""))
    assert OWN_STYLE.sub("", out.getvalue())[:-1].isprintable()
    progress = bars()
    task = progress.add_task(ATTACK, total=None)
    (column,) = [
        column for column in progress.columns if getattr(column, "render", None) and "Words" in repr(type(column))
    ]
    drawn = column.render(progress.tasks[task])
    assert isinstance(drawn, Text) and drawn.plain == shown(ATTACK) and not drawn.spans


def test_an_error_line_of_the_command_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    attack = ATTACK.replace("\udcff", "")
    for arguments in (("suite", "show", attack), ("run", "x", f"--{attack}"), (attack,), ("verify", "physics", attack)):
        done = call(capsys, *arguments)
        assert done.code == 2 and done.err.endswith("\n") and done.err[:-1].isprintable(), ascii(done.err)


def test_a_terminal_is_never_written_to_by_a_label(tmp_path: Path) -> None:
    """The real command on a real terminal."""
    rebuild(tmp_path / "warehouse")
    label = ATTACK.replace("\udcff", "")
    quoted = label.replace("'", "''")
    main, other = pty.openpty()
    with subprocess.Popen(
        [sys.executable, "-m", "c4s.cli", "sql", f"SELECT '{quoted}' AS label, 1 AS \"{label}\""],
        env={**os.environ, "C4S_HOME": str(tmp_path), "TERM": "xterm-256color", "COLUMNS": "400"},
        stdin=subprocess.DEVNULL,
        stdout=other,
        stderr=other,
    ) as process:
        os.close(other)
        told = b""
        while chunk := _read(main):
            told += chunk
    os.close(main)
    assert process.returncode == 0, told
    sound(OWN_STYLE.sub("", told.decode().replace("\r\n", "\n")))


def _read(handle: int) -> bytes:
    try:
        return os.read(handle, 65536)
    except OSError:  # the other end of a terminal is closed
        return b""


def test_pages_write_it_as_text() -> None:
    page = environment().from_string('<td title="{{ name }}">{{ name }}</td>').render(name=ATTACK)
    sound(page)
    assert "<a" not in page
