"""Whether a pack is as it was frozen: its manifest against a case's reference, its files against the manifest."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import json_text
from c4s.records.pack import MANIFEST, STAMP, Pack
from c4s.trees import Change, changes, digests, refuse

Told = Callable[[str], None]


@dataclass(frozen=True)
class _Frozen:
    """What a manifest says of its pack."""

    digest: str
    files: Mapping[str, str]
    faults: tuple[Change, ...]


@lru_cache(maxsize=64)
def _frozen(manifest: Path, bytes_sha256: str) -> _Frozen:
    """The manifest with these bytes. The digest is part of the key alone: other bytes are another manifest."""
    pack = Pack.read(manifest)
    faults: list[Change] = []
    if json_text(pack.plain()).encode() != manifest.read_bytes():
        faults.append(Change(manifest, "unsound", "the manifest is not as c4s writes it"))
    unlisted = sorted(pack.named_files() - set(pack.files))
    meshes = [asset.mesh for asset in pack.assets if asset.mesh and asset.mesh_sha256 != pack.files.get(asset.mesh)]
    faults += [
        Change(manifest, "unsound", f"the manifest has no digest, or two, of {name}") for name in unlisted or meshes
    ]
    return _Frozen(pack.sha256(), pack.files, tuple(faults))


def pack_changes(
    folder: Path, frozen_digest: str | None = None, *, full: bool = False, told: Told | None = None
) -> list[Change]:
    """Everything of a pack that is not as it was frozen.

    Args:
        folder: the pack.
        frozen_digest: of the manifest, as a case or suite holds it; without it the manifest is taken as it is.
        full: read every byte, whatever was known of the files.
        told: called with the name of each file.

    Raises ``BadInput`` when the manifest cannot be read, or where a link lies in the pack.
    """
    manifest = folder / MANIFEST
    if not manifest.is_file():
        raise BadInput("no such pack", where=str(folder), todo="build it, see `c4s catalog build`")
    found = digests(folder, full=full, told=told)
    frozen = _frozen(manifest, found[MANIFEST])
    if frozen_digest is not None and frozen.digest != frozen_digest:
        said = f"this pack has digest {frozen.digest[:12]}, the suite was built with {frozen_digest[:12]}"
        return [Change(manifest, "unsound", said)]
    listed = {name: value for name, value in found.items() if name not in (MANIFEST, STAMP)}
    rows = [*frozen.faults, *changes(folder, frozen.files, listed)]
    if rows and not full:
        return pack_changes(folder, frozen_digest, full=True, told=told)
    return rows


def check_pack(folder: Path, frozen_digest: str | None = None) -> None:
    """Raise ``BadInput`` that names the first file of a pack which is not as it was frozen."""
    refuse(pack_changes(folder, frozen_digest), todo="restore the file, or build the pack again with --replace")
