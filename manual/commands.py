"""The reference of all commands, read off the command line itself."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from c4s.cli.main import command

_HEAD = """# Commands

Every command answers `--help`. Exit codes: 0 done, 1 the answer is no, 2 bad usage or bad input, 3 the machinery
failed, 130 stopped. Errors are one line on standard error; with `--json` standard output holds one JSON value.
"""


def commands_page() -> str:
    """The page as Markdown."""
    parts = [_HEAD]
    for path, one in _leaves(("c4s",), command()):
        parts += [f"## {' '.join(path)}\n", f"```\n{_usage(path, one)}\n```\n", _about(one), _options(one)]
    return "\n".join(parts)


def _leaves(path: tuple[str, ...], one: Any) -> Iterator[tuple[tuple[str, ...], Any]]:
    inner = getattr(one, "commands", None)
    if inner is None:
        yield path, one
        return
    for name, child in inner.items():
        yield from _leaves((*path, name), child)


def _usage(path: tuple[str, ...], one: Any) -> str:
    arguments = [_argument(parameter) for parameter in one.params if parameter.param_type_name == "argument"]
    return " ".join([*path, *arguments, "[OPTIONS]"])


def _argument(parameter: Any) -> str:
    name = parameter.name.upper() + ("..." if parameter.nargs == -1 else "")
    return name if parameter.required else f"[{name}]"


def _about(one: Any) -> str:
    """The docstring without the indentation of its lines."""
    lines = [line.strip() for line in (one.help or "").replace("\b", "").splitlines()]
    return "\n".join(line.replace("<", "\\<") for line in lines) + "\n"


def _options(one: Any) -> str:
    rows = [
        f"| {_cell('`, `'.join(_names(parameter)), code=True)} | {_cell(getattr(parameter, 'help', None) or '')} |"
        for parameter in one.params
        if _names(parameter) and not getattr(parameter, "hidden", False)
    ]
    return "\n".join(["| Option | What it does |", "|---|---|", *rows, ""]) if rows else ""


def _names(parameter: Any) -> list[str]:
    if parameter.param_type_name == "argument":
        return [parameter.name.upper()] if getattr(parameter, "help", None) else []
    return [*parameter.opts, *parameter.secondary_opts]


def _cell(text: str, *, code: bool = False) -> str:
    line = " ".join(text.split()).replace("|", "\\|")
    return f"`{line}`" if code else line.replace("<", "\\<")
