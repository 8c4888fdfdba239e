"""Packages that only some commands need: extras of the wheel, so that the others install without them."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Final, Literal

from c4s.errors import BadInput

Extra = Literal["service", "s3", "plots", "telemetry"]
PACKAGES: Final[dict[Extra, str]] = {
    "service": "prefect",
    "s3": "s3fs",
    "plots": "matplotlib",
    "telemetry": "opentelemetry.exporter.otlp.proto.http",
}
"""By extra the package whose presence tells that it is installed."""


def install(extra: Extra) -> str:
    """The command that installs an extra."""
    return f"pip install 'c4s[{extra}]'"


def is_installed(extra: Extra) -> bool:
    """Whether an extra is installed; nothing of it is imported, but for the package that it lies in."""
    try:
        return find_spec(PACKAGES[extra]) is not None
    except ModuleNotFoundError:
        return False


def need(extra: Extra, what: str) -> None:
    """``BadInput`` where ``what`` was asked for and its extra is not installed."""
    if not is_installed(extra):
        raise BadInput(f"{what} needs {PACKAGES[extra]}, which is not installed", todo=install(extra))
