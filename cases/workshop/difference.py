"""What differs between two built suites, case by case."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from c4s.files import read_written_json
from c4s.records.suite import DIGESTS, SuiteFolder

Change = Literal["added", "removed", "changed", "same"]


@dataclass(frozen=True)
class CaseDifference:
    """A case of either suite. ``parts`` name what is not the same: files of the case, without their folders."""

    case_id: str
    change: Change
    parts: tuple[str, ...] = ()


@dataclass(frozen=True)
class SuiteDifference:
    """Cases in order, and packs that only one of two suites names, or of which they name two versions."""

    cases: tuple[CaseDifference, ...]
    packs: tuple[str, ...]

    @property
    def same(self) -> bool:
        """Whether nothing differs."""
        return not self.packs and all(case.change == "same" for case in self.cases)


def difference(before: SuiteFolder, after: SuiteFolder) -> SuiteDifference:
    """Compare two built suites by the digests of their files."""
    sides = (before, after)
    listed = [{case.case_id: case for case in side.suite().cases} for side in sides]
    files = [_files(side) for side in sides]
    rows = []
    for case_id in sorted(set(listed[0]) | set(listed[1])):
        if case_id not in listed[1]:
            rows.append(CaseDifference(case_id, "removed"))
        elif case_id not in listed[0]:
            rows.append(CaseDifference(case_id, "added"))
        else:
            own = [files[at].get(case_id, {}) for at in (0, 1)]
            parts = sorted(name for name in set(own[0]) | set(own[1]) if own[0].get(name) != own[1].get(name))
            rows.append(CaseDifference(case_id, "changed" if parts else "same", tuple(parts)))
    packs = [{pack.pack_id: pack.digest for pack in side.suite().packs} for side in sides]
    changed = sorted(name for name in set(packs[0]) | set(packs[1]) if packs[0].get(name) != packs[1].get(name))
    return SuiteDifference(tuple(rows), tuple(changed))


def _files(suite: SuiteFolder) -> dict[str, dict[str, str]]:
    """Digests of the files of each case, ``agent/...`` and ``withheld/...`` without the case's own folder."""
    names = {case.alias: case.case_id for case in suite.suite().cases}
    found: dict[str, dict[str, str]] = {}
    for path, sha256 in read_written_json(suite.root / DIGESTS).items():
        tree, folder, name = path.split("/", 2)
        case_id = names[folder] if tree == "agent" else folder
        found.setdefault(case_id, {})[f"{tree}/{name}"] = sha256
    return found
