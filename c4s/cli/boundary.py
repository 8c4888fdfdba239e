"""The command line's boundary: an error becomes one line on standard error and an exit code."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import NoReturn

import click

from c4s.errors import C4SError

OK, NO, BAD_INPUT, MACHINERY = 0, 1, 2, 3


def run(command: Callable[[], object]) -> NoReturn:
    """Run a click command and exit: 0 done, 1 the answer is no, 2 bad usage or input, 3 the machinery failed."""
    try:
        code = command()
        sys.exit(code if isinstance(code, int) else OK)
    except C4SError as error:
        print(f"c4s: {error.line()}", file=sys.stderr)
        sys.exit(error.exit_code)
    except click.UsageError as error:
        hint = f" (see `{error.ctx.command_path} --help`)" if error.ctx else ""
        print(f"c4s: {error.format_message()}{hint}", file=sys.stderr)
        sys.exit(BAD_INPUT)
    except click.exceptions.Exit as error:
        sys.exit(error.exit_code)
    except (KeyboardInterrupt, click.Abort):
        print("c4s: stopped; run the same command to go on", file=sys.stderr)
        sys.exit(130)
    except BrokenPipeError:
        sys.stderr.close()
        sys.exit(OK)
    except OSError as error:
        print(f"c4s: {error.strerror or error}: {error.filename or ''}".rstrip(": "), file=sys.stderr)
        sys.exit(MACHINERY)
