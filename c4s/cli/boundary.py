"""The command line's boundary: an error becomes one line on standard error and an exit code.

It is the same with ``--json``: standard output then holds one JSON value, or nothing where there is an error.
"""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Callable
from typing import NoReturn

import typer
from typer.exceptions import TyperException

from c4s.errors import C4SError
from c4s.files import no_place
from c4s.stderr import tell

OK, NO, BAD_INPUT, MACHINERY, STOPPED = 0, 1, 2, 3, 130
MOST_CHARACTERS = 1_500
"""Longest line: what is wrong may quote a file."""
PLACES = {
    *(errno.ENOENT, errno.ENOTDIR, errno.EISDIR, errno.EEXIST, errno.ENOTEMPTY, errno.EACCES, errno.EPERM),
    *(errno.EROFS, errno.ELOOP, errno.ENAMETOOLONG, errno.EINVAL, errno.EXDEV, errno.ENXIO),
}
"""The system's errors about a place that was named, not about the machine: bad input."""


def usage_line(error: TyperException) -> str:
    """A usage error as one line, with where to read more."""
    text = " ".join(str(getattr(error, "format_message", error.__str__)()).split())
    context = getattr(error, "ctx", None)
    return f"{text} (see `{context.command_path} --help`)" if context else text


def _line(text: str) -> None:
    """One line on standard error; a long text is cut in its middle."""
    line = " ".join(text.split())
    if len(line) > MOST_CHARACTERS:
        line = f"{line[: MOST_CHARACTERS // 2]} … {line[-MOST_CHARACTERS // 2 :]}"
    tell(f"c4s: {line}", "error")


def run(command: Callable[[], object]) -> NoReturn:
    """Run a click command and exit: 0 done, 1 the answer is no, 2 bad usage or input, 3 the machinery failed.

    Anything that no policy names is a fault of c4s: its traceback goes to a file, and the line says which.
    """
    code = _code(command)
    try:
        fault = _output_fault()
    except BrokenPipeError:
        code, fault = OK, None
    if fault is not None:
        _line(fault)
        code = MACHINERY
    sys.exit(code)


def _output_fault() -> str | None:
    """Why standard output takes nothing more, once; from then on it takes all and keeps nothing."""
    try:
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            raise
        return f"standard output: {no_place(error)}"
    return None


def _code(command: Callable[[], object]) -> int:
    try:
        code = command()
        return code if isinstance(code, int) else OK
    except C4SError as error:
        _line(error.line())
        return error.exit_code
    except typer.Exit as error:
        return error.exit_code
    except (KeyboardInterrupt, typer.Abort):
        _line("stopped; run the same command to go on")
        return STOPPED
    except TyperException as error:
        if not str(error):  # a group without a command has printed its help
            return OK
        _line(usage_line(error))
        return BAD_INPUT
    except (BrokenPipeError, SystemExit):  # typer ends the process itself where a reader has gone, and only there
        return OK
    except OSError as error:
        fault = f"{error.filename}: {no_place(error)}" if error.filename else _output_fault() or no_place(error)
        _line(fault)
        return BAD_INPUT if error.errno in PLACES and error.filename else MACHINERY
    except Exception as error:
        _line(f"this is a fault of c4s: {error} (please report it; the traceback is in {_traceback(error)})")
        return MACHINERY


def _traceback(error: BaseException) -> str:
    """The file that the traceback is written to."""
    import tempfile
    import traceback

    with tempfile.NamedTemporaryFile("w", prefix="c4s-fault-", suffix=".txt", delete=False, encoding="utf-8") as file:
        file.write("".join(traceback.format_exception(error)).encode(errors="backslashreplace").decode())
    return file.name
