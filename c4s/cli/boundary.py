"""The command line's boundary: an error becomes one line on standard error and an exit code."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import NoReturn

import typer
from typer.exceptions import TyperException

from c4s.errors import C4SError

OK, NO, BAD_INPUT, MACHINERY = 0, 1, 2, 3


def usage_line(error: TyperException) -> str:
    """A usage error as one line, with where to read more."""
    text = str(getattr(error, "format_message", error.__str__)())
    context = getattr(error, "ctx", None)
    return f"{text} (see `{context.command_path} --help`)" if context else text


def run(command: Callable[[], object]) -> NoReturn:
    """Run a click command and exit: 0 done, 1 the answer is no, 2 bad usage or input, 3 the machinery failed."""
    try:
        code = command()
        sys.exit(code if isinstance(code, int) else OK)
    except C4SError as error:
        print(f"c4s: {error.line()}", file=sys.stderr)
        sys.exit(error.exit_code)
    except typer.Exit as error:
        sys.exit(error.exit_code)
    except (KeyboardInterrupt, typer.Abort):
        print("c4s: stopped; run the same command to go on", file=sys.stderr)
        sys.exit(130)
    except TyperException as error:
        print(f"c4s: {usage_line(error)}", file=sys.stderr)
        sys.exit(BAD_INPUT)
    except BrokenPipeError:
        sys.stderr.close()
        sys.exit(OK)
    except OSError as error:
        print(f"c4s: {error.strerror or error}: {error.filename or ''}".rstrip(": "), file=sys.stderr)
        sys.exit(MACHINERY)
