"""What of an editor's host is there: for people who set one up."""

from __future__ import annotations

from pathlib import Path

from c4s.engine.finding import EngineFinding
from c4s.engine.unreal.host.installation import KIND, PINNED, find_installation, installed
from c4s.errors import MachineryFault

_DRIVERS = (Path("/proc/driver/nvidia/gpus"), Path("/dev/dri"))
_WITHOUT = "without it scenes are built on the headless engine, and are never ranked with Unreal results"


def findings() -> list[EngineFinding]:
    """The editor, its plugins, and a GPU to draw with."""
    try:
        found = installed()
    except MachineryFault as fault:
        return [EngineFinding("Unreal Editor", False, f"{fault.line()}; {_WITHOUT}")]
    try:
        find_installation(found.kind)
        editor = EngineFinding("Unreal Editor", True, f"{found.version} in {found.root}, engine {found.kind}")
    except MachineryFault as fault:
        editor = EngineFinding("Unreal Editor", False, fault.line())
    missing = found.missing_plugins()
    plugins = f"not there: {', '.join(missing)}" if missing else f"as c4s needs them for {PINNED}"
    drivers = [str(place) for place in _DRIVERS if place.is_dir() and any(place.iterdir())]
    gpu = ", ".join(drivers) if drivers else "none is seen: a real editor draws no picture without one"
    rows = [editor, EngineFinding("editor plugins", not missing, plugins)]
    return [*rows, EngineFinding("GPU", bool(drivers), gpu)] if found.kind == KIND else rows
