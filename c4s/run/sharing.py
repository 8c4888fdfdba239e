"""What machines that share an object store tell each other of a run in work: their journals, and what they spent.

Each machine appends to files of its own in the run folder, puts them as ``elsewhere/<machine>/`` into the store now
and then, and fetches the folders of the others. Whoever counts reads its own files and those below ``elsewhere``.
"""

from __future__ import annotations

import os
import platform
import re
import uuid
from contextlib import suppress
from pathlib import Path

from c4s.files import digest_file
from c4s.home import home
from c4s.records.folder import RunFolder
from c4s.run.store import open_store

FETCH_S = 10.0
"""How often machines that share a store hear of each other."""


def machine() -> str:
    """This home's name among all that share the store: its host, and a part that is drawn once and kept in it.

    A home that was copied to another host, or whose host was renamed, is another machine: what it spent before is then
    counted twice, so a limit is reached early and never late.
    """
    place = home() / "machine"
    if not place.is_file():
        name = uuid.uuid4().hex
        drawn = place.with_name(f".machine-{name}")
        drawn.write_text(name[:8])
        with suppress(FileExistsError):
            os.link(drawn, place)
        drawn.unlink()
    return f"{re.sub('[^A-Za-z0-9.-]', '-', platform.node())[:60]}-{place.read_text()}"


class Sharing:
    """What this process appends to: its journal, and the spending file of its machine.

    Args:
        run: the run folder.
        journal: this process's journal.
    """

    def __init__(self, run: RunFolder, journal: Path) -> None:
        self._run, self._journal = run, journal
        self._sent: dict[Path, str] = {}

    def exchange(self) -> None:
        """Send what has grown, and fetch what others sent. ``MachineryFault`` where the store is not reached."""
        self.send()
        fetch_elsewhere(self._run)

    def send(self) -> None:
        """Send what has grown."""
        for path in (self._journal, self._run.spending, self._run.judging):
            if path.is_file() and self._sent.get(path) != (sha256 := digest_file(path)):
                open_store().put(path, self._run.of_machine(machine()) / path.relative_to(self._run.root))
                self._sent[path] = sha256


def fetch_elsewhere(run: RunFolder) -> None:
    """Fetch what other machines sent of a run; nothing where all machines see one folder."""
    store = open_store()
    if store.apart:
        own = f"{machine()}/"
        store.pull_files(run.elsewhere, lambda name: not name.startswith(own))
