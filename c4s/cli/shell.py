"""``c4s sql --shell``: questions one after another. Without a terminal, standard input is a script."""

from __future__ import annotations

import re
import shlex
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final

from c4s.cli.output import check_new_file, print_table, say
from c4s.errors import BadInput, C4SError, unknown
from c4s.home import cache_root, warehouse_root

PROMPT, MORE = "c4s> ", " ...> "
HISTORY: Final = "sql-history"
MOST_HISTORY: Final = 1_000
HELP: Final = """Ask in SQL, to the next ; or name a question. A line that begins with a dot is a command:
.tables            tables and questions
.schema [NAME]     columns and their types
.export FILE       the last answer as a .csv, .parquet or .xlsx file; FILE is not overwritten
.help              this
.quit              as Ctrl-D; Ctrl-C leaves what was typed"""
COMMANDS: Final = (".tables", ".schema", ".export", ".help", ".quit")
_WORD = re.compile(r"[\w.]+$")


class SqlShell:
    """Takes lines; a statement ends with a semicolon, a question's name or a command with its line."""

    def __init__(self) -> None:
        from warehouse.database import columns_of

        self.columns = columns_of(warehouse_root())
        self.pending: list[str] = []
        self.last: str | None = None

    def names(self) -> list[str]:
        """What a word may be completed to: commands, tables and questions, columns."""
        return sorted({*COMMANDS, *self.columns, *(name for found in self.columns.values() for name in found)})

    def take(self, line: str) -> bool:
        """One line; False where it ends the shell. ``C4SError`` for one that cannot be answered."""
        text = line.strip()
        if not self.pending and text.startswith("."):
            return self._command(text)
        if not self.pending and (name := text.rstrip("; ")) in self.columns:
            text = f"SELECT * FROM {name};"
        if text or self.pending:
            self.pending.append(text)
        if text.endswith(";"):
            self.finish()
        return True

    def finish(self) -> None:
        """Answer what is pending."""
        query, self.pending = "\n".join(self.pending).strip(), []
        if query.rstrip("; \n"):
            self._ask(query)

    def _ask(self, query: str) -> None:
        from warehouse.database import ask, catch_up

        catch_up(warehouse_root())
        columns, rows = ask(warehouse_root(), query)
        self.last = query
        print_table(columns, rows)
        say(f"{len(rows)} row{'' if len(rows) == 1 else 's'}", style="dim")

    def _command(self, text: str) -> bool:
        try:
            name, *rest = shlex.split(text)
        except ValueError as error:
            raise BadInput(str(error), where=text) from None
        does: dict[str, Callable[[list[str]], None]] = {
            ".tables": self._tables,
            ".schema": self._schema,
            ".export": self._export,
            ".help": lambda _: self._help(),
        }
        if name in (".quit", ".exit"):
            return False
        if name not in does:
            raise unknown("command", name, COMMANDS, todo=".help lists them")
        does[name](rest)
        return True

    def _help(self) -> None:
        for line in HELP.splitlines():
            say(line)

    def _tables(self, rest: list[str]) -> None:
        print_table(["name", "columns"], [[name, len(found)] for name, found in self.columns.items()])

    def _schema(self, rest: list[str]) -> None:
        for name in rest or self.columns:
            if name not in self.columns:
                raise unknown("table or question", name, self.columns)
            print_table(["column", "type"], [*map(list, self.columns[name].items())], title=name)

    def _export(self, rest: list[str]) -> None:
        from warehouse.frames import export

        if len(rest) != 1:
            raise BadInput("one file", where=".export", todo=".export rows.csv")
        if self.last is None:
            raise BadInput("nothing was asked yet", where=".export", todo="ask, then export the answer")
        check_new_file(Path(rest[0]))
        say(f"{export(warehouse_root(), self.last, Path(rest[0]))} rows: {rest[0]}")


def run_shell() -> int:
    """Read lines to the end of input; the exit code.

    At a terminal an error is told and the shell goes on. A script ends with its first error, as ``c4s sql`` does.
    """
    shell = SqlShell()
    if not sys.stdin.isatty():
        for line in sys.stdin:
            if not shell.take(line):
                return 0
        shell.finish()
        return 0
    with _history(shell.names()):
        say("Ask in SQL, or name a question. .help tells more.", style="dim")
        while True:
            try:
                if not shell.take(input(MORE if shell.pending else PROMPT)):
                    return 0
            except KeyboardInterrupt:
                shell.pending = []
                say("")
            except EOFError:
                say("")
                return 0
            except C4SError as error:
                shell.pending = []
                say(error.line(), style="red")


def completions(names: Iterable[str], line: str) -> list[str]:
    """Names that go on from the last word of a line."""
    word = _WORD.search(line)
    return [name for name in names if word and name.startswith(word.group())]


@contextmanager
def _history(names: Sequence[str]) -> Iterator[None]:
    """Completion with the tab key, and lines of earlier shells; those of this one are kept at its end."""
    import readline

    kept = cache_root() / HISTORY
    kept.parent.mkdir(parents=True, exist_ok=True)
    with suppress(OSError):
        readline.read_history_file(kept)
    readline.set_history_length(MOST_HISTORY)
    readline.set_completer_delims(" \t\n,();=<>'\"")
    readline.set_completer(lambda text, state: [*completions(names, text), None][state] if text else None)
    readline.parse_and_bind("tab: complete")
    try:
        yield
    finally:
        with suppress(OSError):
            readline.write_history_file(kept)
