"""A finished pack takes its place: nothing is replaced without being asked, and never by halves."""

from __future__ import annotations

from pathlib import Path

from c4s.errors import BadInput
from c4s.folders import check_own, put_folder
from c4s.packs.check import pack_changes
from c4s.records.pack import MANIFEST, Pack
from c4s.trees import refuse

REMEDY = "give --replace to build it anew; suites that were built with it must then be built again"


def check_kept(place: Path) -> None:
    """Raise ``BadInput`` for the first file of a pack that was changed since it was built."""
    refuse(pack_changes(place), todo=f"restore the file, or {REMEDY}")


def settle(made: Path, place: Path, *, replace: bool) -> None:
    """Put a finished pack at ``place``, unless the same pack lies there unchanged.

    Raises ``BadInput`` where another one, or one that was changed, lies there and ``replace`` is not given, and always
    where something lies there that is no pack.
    """
    check_own(place, MANIFEST)
    if place.exists() and not replace:
        found, wanted = Pack.read(place / MANIFEST).sha256(), Pack.read(made / MANIFEST).sha256()
        if found != wanted:
            told = f"another pack of this name lies here (digest {found[:12]}, the new one {wanted[:12]})"
            raise BadInput(told, where=str(place), todo=REMEDY)
        check_kept(place)
        return
    put_folder(made, place, marker=MANIFEST)
