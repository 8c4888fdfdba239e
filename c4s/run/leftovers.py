"""Temporary folders that tell whose they are, so that those of processes that were killed can be removed."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

from c4s.folders import remove_tree
from c4s.run.owner import is_gone, this_process

_NAME = re.compile(r"c4s-w-([0-9a-f]+)-(\d+)-(\d+)-\w+")


def owned_folder() -> Path:
    """A new temporary folder of this process."""
    own = this_process()
    return Path(tempfile.mkdtemp(prefix=f"c4s-w-{_number(own.pid_namespace)}-{own.pid}-{own.started_ticks}-"))


def sweep() -> list[Path]:
    """Remove the folders whose owner has ended, and tell which; those of another machine or container stay."""
    own, removed = this_process(), []
    for folder in Path(tempfile.gettempdir()).glob("c4s-w-*"):
        named = _NAME.fullmatch(folder.name)
        if named is None or named[1] != _number(own.pid_namespace):
            continue
        owner = own.model_copy(update={"pid": int(named[2]), "started_ticks": int(named[3])})
        if is_gone(owner):
            remove_tree(folder, inside=folder.parent, at_best=True)
            removed.append(folder)
    return removed


def _number(namespace: str) -> str:
    """``effffffc`` of ``pid:[4026531836]``: a socket's path has little room."""
    return f"{int(namespace.rpartition('[')[2].rstrip(']')):x}"
