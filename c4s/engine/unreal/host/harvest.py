"""What an editor saved, copied out of its project into the content folder of the attempt."""

from __future__ import annotations

import shutil
import threading
from contextlib import suppress
from pathlib import Path

from c4s.engine.unreal.host.project import GAME, Project, saved_packages
from c4s.files import append_json_line
from c4s.records.folder import SAVES

Stamp = tuple[int, int]


class Harvest:
    """Copies packages that are new or changed, and notes the levels among them in the list of saves."""

    def __init__(self, project: Project, content: Path | None) -> None:
        """``content``: where to; None for an editor that may save nothing."""
        self._project, self._content = project, content
        self._known: dict[Path, Stamp | None] = {}
        self._begun = False
        self._lock = threading.Lock()

    def begin(self) -> None:
        """Copy from now on; what lies there now, the levels of documents too, is none of the agent's."""
        with self._lock:
            self._known = {name: self._stamp(name) for name in saved_packages(self._project)}
            self._begun = True

    def gather(self) -> None:
        """Copy what was saved since the last time, in the order in which it was written."""
        with self._lock:
            if self._content is None or not self._begun:
                return
            for name in saved_packages(self._project):
                stamp = self._stamp(name)
                if self._known.get(name) == stamp:
                    continue
                self._known[name] = stamp
                target = self._content / GAME / name
                target.parent.mkdir(parents=True, exist_ok=True)
                with suppress(FileNotFoundError):  # a script that still runs may have removed it again
                    shutil.copyfile(self._project.content / name, target, follow_symlinks=False)
                if name.suffix == ".umap":
                    append_json_line(self._content / SAVES, {"package": f"/Game/{name.with_suffix('').as_posix()}"})

    def close(self) -> None:
        """Copy nothing from now on."""
        with self._lock:
            self._content = None

    def _stamp(self, name: Path) -> Stamp | None:
        """When it was written and how large it is; None when it has just gone."""
        try:
            told = (self._project.content / name).lstat()
        except FileNotFoundError:
            return None
        return told.st_mtime_ns, told.st_size
