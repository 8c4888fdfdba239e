"""What an editor's crash report says."""

from __future__ import annotations

import re
from pathlib import Path

_FIRST_LINES = 8
_MOST_BYTES = 1 << 20
_FIELD = re.compile(r"<(ErrorMessage|CallStack)>(.*?)</\1>", re.DOTALL)
CONTEXT = "CrashContext.runtime-xml"


def crash_report(crashes: Path) -> str:
    """The newest report's folder, its message and the first lines of its call stack; empty where there is none."""
    found = sorted(crashes.glob(f"*/{CONTEXT}"), key=lambda file: file.stat().st_mtime_ns)
    if not found:
        return ""
    with found[-1].open("rb") as file:
        text = file.read(_MOST_BYTES).decode("utf-8", "replace")
    fields = {name: value.strip() for name, value in _FIELD.findall(text)}
    stack = fields.get("CallStack", "").splitlines()[:_FIRST_LINES]
    told = [fields.get("ErrorMessage", ""), *(line.strip() for line in stack)]
    return f"crash report {found[-1].parent.name}: {' | '.join(line for line in told if line)}"
