"""Whether a suite is as it was frozen: both trees of its cases and the packs that they name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Protocol

from c4s.errors import BadInput
from c4s.files import read_written_json
from c4s.home import packs_root
from c4s.packs.check import Told, check_pack, pack_changes
from c4s.records.suite import DIGESTS, FROZEN, SELECTION, SIGHTINGS, AgentCase, SuiteCase, SuiteFolder
from c4s.trees import Change, Listing, changes, digests, listing_digest, refuse

_LOOSE = frozenset({"suite.json", DIGESTS, "build.json", SIGHTINGS, FROZEN, SELECTION})
"""Files beside the two trees."""


class FrozenCase(Protocol):
    """A case with the digests that a suite or a plan froze."""

    @property
    def case_id(self) -> str: ...

    @property
    def alias(self) -> str: ...

    @property
    def agent_digest(self) -> str: ...

    @property
    def withheld_digest(self) -> str: ...


def _trees(case: FrozenCase) -> tuple[str, str]:
    """The agent's and the withheld folder of a case, relative to the suite's."""
    return f"agent/{case.alias}", f"withheld/{case.case_id}"


def case_changes(suite: SuiteFolder, case: FrozenCase, *, full: bool = False, told: Told | None = None) -> list[Change]:
    """Every file of a case's two trees that is not as it was frozen. ``BadInput`` for a link."""
    rows: list[Change] = []
    for tree, frozen in zip(_trees(case), (case.agent_digest, case.withheld_digest), strict=True):
        folder = suite.root / tree
        for place in (folder.parent, folder):
            if place.is_symlink():
                raise BadInput("a link is not allowed in a frozen folder", where=str(place))
        found = digests(folder, full=full, told=told)
        if listing_digest(found) != frozen:
            rows += _named(folder, _frozen_listing(suite, f"{tree}/"), frozen, found)
    return rows if full or not rows else case_changes(suite, case, full=True, told=told)


def _frozen_listing(suite: SuiteFolder, prefix: str) -> Listing:
    """What the suite noted of a tree's files; nothing where the note cannot be read."""
    try:
        noted = read_written_json(suite.root / DIGESTS)
    except BadInput:
        return {}
    return {name.removeprefix(prefix): value for name, value in noted.items() if name.startswith(prefix)}


def _named(folder: Path, noted: Listing, frozen: str, found: Listing) -> list[Change]:
    """The files that make a tree another one; the tree itself where the suite's note is of another one."""
    if noted and listing_digest(noted) == frozen:
        return changes(folder, noted, found)
    return [Change(folder, "unsound", "these are not the files that were frozen")]


def check_case(suite: SuiteFolder, case: FrozenCase) -> tuple[AgentCase, list[Path]]:
    """The agent's side of a case and its pack folders, all of it as it was frozen; ``BadInput`` names what is not.

    The case's digests are those of the plan or suite that froze it; unchanged files are not read again.
    """
    name = suite.root.name
    refuse(
        case_changes(suite, case),
        todo=f"`c4s suite check {name}` lists every file; restore it, or build the suite again with --replace",
    )
    opened = suite.agent_case(case.alias)
    folders = [packs_root() / reference.pack_id for reference in opened.packs]
    for folder, reference in zip(folders, opened.packs, strict=True):
        if not folder.is_dir():
            raise BadInput(
                f"pack {reference.pack_id!r} is missing", where=case.case_id, todo=f"build it into {packs_root()}"
            )
        check_pack(folder, reference.digest)
    return opened, folders


def tree_changes(suite: SuiteFolder) -> list[Change]:
    """Every file of a suite's two trees that is not as it was frozen; unchanged files are not read again."""
    return _kept(lambda: [row for case in suite.suite().cases for row in case_changes(suite, case)])


def suite_changes(suite: SuiteFolder, told: Told | None = None) -> list[Change]:
    """Every file of a suite and of its packs that is not as it was frozen. Every byte is read.

    Raises ``BadInput`` where ``suite.json`` is not what was written: then there is nothing to compare with.
    """
    record = suite.suite()
    rows, packs = _strangers(suite, record.cases), list(record.packs)
    for case in record.cases:
        found = _kept(lambda case=case: case_changes(suite, case, full=True, told=told))  # type: ignore[misc]
        rows += found
        if not found:
            packs += suite.agent_case(case.alias).packs
            rows += _note_changes(suite, case)
    for pack_id, digest in sorted({(reference.pack_id, reference.digest) for reference in packs}):
        folder = packs_root() / pack_id
        rows += _kept(lambda at=folder, frozen=digest: pack_changes(at, frozen, full=True, told=told))  # type: ignore[misc]
    return list(dict.fromkeys(rows))


def _kept(find: Callable[[], list[Change]]) -> list[Change]:
    """What is found, or the reason why nothing can be compared, as a change."""
    try:
        return find()
    except BadInput as error:
        return [Change(Path(error.where), "unsound", error.what)]


def _strangers(suite: SuiteFolder, cases: Sequence[FrozenCase]) -> list[Change]:
    """What lies in the suite's folder and belongs to no case."""
    known = {suite.root / folder for case in cases for folder in _trees(case)}
    trees = {folder.parent for folder in known}
    rows = [path for path in suite.root.iterdir() if path.name not in _LOOSE and path not in trees]
    rows += [path for tree in trees if tree.is_dir() for path in tree.iterdir() if path not in known]
    return [Change(path, "extra") for path in sorted(rows)]


def _note_changes(suite: SuiteFolder, case: SuiteCase) -> list[Change]:
    """The suite's note of its files, where it is not that of a case that is as it was frozen."""
    noted = [listing_digest(_frozen_listing(suite, f"{tree}/")) for tree in _trees(case)]
    return [] if noted == [case.agent_digest, case.withheld_digest] else [Change(suite.root / DIGESTS, "changed")]
