"""The evidence of one submission as verifiers and judges are given it: named files, read on demand.

Who reads a file through here leaves its SHA-256 in ``digests``, so a verdict or judgement names exactly what it read.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

from c4s.errors import BadInput
from c4s.files import digest_bytes, parse_json, read_plain
from c4s.names import file_in
from c4s.protocol.settings import Setting
from c4s.records.base import Record
from c4s.records.pack import MANIFEST, Pack

EvidenceName = Literal[
    "candidate_snapshot",
    "dependencies",
    "captures",
    "contacts",
    "support",
    "navigation",
    "input_snapshot",
    "truth_snapshot",
    "requirements",
    "binding",
    "judgements",
]


class ManifestDigests(Record):
    """Digests of packs by their id, from three sides."""

    frozen: dict[str, str]
    """What the suite froze for the case."""
    submission: dict[str, str]
    """What the agent's engine had mounted when it saved the scene."""
    scorer: dict[str, str]
    """What the evaluator's engine has mounted."""


@dataclass
class Evidence:
    """Files of one submission and of its case. ``files`` may name files that are not there: ``has`` tells."""

    setting: Setting
    prompt: str
    files: Mapping[EvidenceName, Path]
    packs: Sequence[Path] = ()
    """Pack folders of the case, for what an asset is called and made of."""
    noted: Mapping[EvidenceName, str] = field(default_factory=dict)
    """The digests that these files had when they were made; any other is refused."""
    noted_files: Mapping[Path, str] | None = None
    """The digests that the pictures beside the captures had when they were made; None where nobody kept them."""
    minimum_actors: int = 1
    """Of the case: fewer make a scene invalid."""
    manifest: ManifestDigests | None = None
    """For the integrity gate alone."""
    digests: dict[str, str] = field(default_factory=dict)
    """SHA-256 (64 hex) of each file that was read, by its name."""

    def only(self, names: Collection[EvidenceName]) -> Evidence:
        """The same evidence with these files alone, of which nothing was read yet."""
        return replace(
            self,
            files={name: path for name, path in self.files.items() if name in names},
            noted={name: sha256 for name, sha256 in self.noted.items() if name in names},
            digests={},
        )

    def has(self, name: EvidenceName) -> bool:
        """Whether the file is there."""
        return name in self.files and self.files[name].is_file()

    def path(self, name: EvidenceName) -> Path:
        """Where a file lies. The caller reads it and adds its digest."""
        if name not in self.files:
            raise BadInput(f"there is no {name.replace('_', ' ')} among this evidence")
        return self.files[name]

    def json(self, name: EvidenceName) -> Any:
        """A file as plain data. Raises ``BadInput`` when it is missing or is no JSON."""
        path, what = self.path(name), name.replace("_", " ")
        data = read_plain(path, what)
        try:
            value = parse_json(data)
        except ValueError as error:
            raise BadInput(f"the {what} is not valid JSON: {error}", where=str(path), todo="is it complete?") from None
        self.note(name, digest_bytes(data))
        return value

    def beside_captures(self, file: str) -> bytes:
        """A picture or actor mask of the captures. ``BadInput`` where it is missing, or not the one that was made."""
        path = file_in(self.path("captures").parent, file)
        data = read_plain(path, "picture")
        sha256 = digest_bytes(data)
        if self.noted_files is not None and self.noted_files.get(path) != sha256:
            raise _changed(path)
        self.digests[f"captures/{file}"] = sha256
        return data

    def note(self, name: str, sha256: str) -> None:
        """Note what was read. ``BadInput`` when the file is not the one that was made."""
        for known, path in self.files.items():
            if known == name and known in self.noted and self.noted[known] != sha256:
                raise _changed(path)
        self.digests[name] = sha256

    def catalog(self) -> dict[str, dict[str, Any]]:
        """What a judge may know of the assets of the case's packs."""
        packs = [Pack.read(folder / MANIFEST) for folder in self.packs]
        self.digests.update({f"pack {pack.pack_id}": pack.sha256() for pack in packs})
        return catalog_facts(packs)


def _changed(path: Path) -> BadInput:
    return BadInput(
        "the file has changed since it was written",
        where=str(path),
        todo="restore the file, or run this trial again under another --run-id",
    )


def catalog_facts(packs: Iterable[Pack]) -> dict[str, dict[str, Any]]:
    """Asset path to name, category, tags, description, size and slot materials."""
    facts: dict[str, dict[str, Any]] = {}
    for pack in packs:
        materials = {material.path: material.plain() for material in pack.materials}
        for asset in pack.assets:
            facts[asset.path] = {
                "name": asset.name,
                "category": asset.category,
                "tags": asset.tags,
                "description": asset.description,
                "size_m": list(asset.size_m),
                "materials": [materials[slot.material] for slot in asset.slots if slot.material in materials],
            }
    return facts
