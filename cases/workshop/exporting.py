"""A copy of a built suite for others: all of it, or its public cases alone."""

from __future__ import annotations

import shutil
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import read_json, write_bytes, write_json
from c4s.folders import beside, put_folder
from c4s.home import packs_root
from c4s.packs.suite_check import suite_changes
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import SUITE, Suite, SuiteFolder
from c4s.trees import files_under, refuse
from cases.sharing import share_equal

LICENCES, LICENCE_WORDS = "licences", "LICENSE.txt"
"""A copy's folder of the licences of its packs, and what a pack calls the words of its own."""


def export_suite(suite: SuiteFolder, out: Path, *, public_only: bool) -> Suite:
    """Copy a suite to ``out``; with ``public_only`` nothing of a private case is in it. Returns what was written.

    The copy names the licence of each pack, and who is to be named, in a file of ``licences``.

    Raises ``BadInput`` where a file was changed, ``out`` is there already, or no case is public.
    """
    refuse(suite_changes(suite), todo="restore the files, or build again with --replace")
    if out.exists():
        raise BadInput("this is there already", where=str(out), todo="name a new folder")
    record = suite.suite()
    withheld = {case.case_id: suite.withheld_case(case.case_id) for case in record.cases}
    kept = [case for case in record.cases if not public_only or withheld[case.case_id].visibility == "public"]
    if not kept:
        raise BadInput("no case of this suite is public", where=record.suite_id)
    out.parent.mkdir(parents=True, exist_ok=True)
    with beside(out) as scratch:
        folder = SuiteFolder(scratch / "suite")
        for case in kept:
            shutil.copytree(suite.agent(case.alias), folder.agent(case.alias))
            shutil.copytree(suite.withheld(case.case_id), folder.withheld(case.case_id))
        share_equal(folder.root / "withheld")
        packs = {pack.pack_id for case in kept for pack in folder.agent_case(case.alias).packs}
        made = folder.freeze(
            record.suite_id, record.title, record.description, [pack for pack in record.packs if pack.pack_id in packs]
        )
        if suite.sightings.is_file():
            seen = read_json(suite.sightings)
            write_json(folder.sightings, {case.case_id: seen[case.case_id] for case in kept if case.case_id in seen})
        for pack in made.packs:
            _licence(pack.pack_id, folder.root)
        _check_clean(folder.root, {case.case_id for case in record.cases} - {case.case_id for case in kept}, record)
        put_folder(folder.root, out, marker=SUITE)
    return made


def _licence(pack_id: str, root: Path) -> None:
    """Write who made the meshes that the pictures of a copy show, and under which licence: ``licences/PACK.txt``."""
    folder = packs_root() / pack_id
    pack = Pack.read(folder / MANIFEST)
    words = folder / LICENCE_WORDS
    told = words.read_text(encoding="utf-8", errors="replace") if words.is_file() else ""
    changed = "made into meshes of c4s, and changed in that" if told else "no words of a licence came with it"
    head = f"Pack {pack_id}: {pack.title}\n{pack.description}; {changed}\nLicence: {pack.license}\n"
    write_bytes(root / LICENCES / f"{pack_id}.txt", f"{head}\n{told}".encode())


def _check_clean(root: Path, left_out: set[str], record: Suite) -> None:
    """``BadInput`` where a file names a case that is not in the copy."""
    aliases = {case.alias for case in record.cases if case.case_id in left_out}
    secret = [name.encode() for name in sorted(left_out | aliases)]
    for name, _ in files_under(root):
        data = (root / name).read_bytes()
        for word in secret:
            if word in data or word in name.encode():
                raise BadInput(f"this file names the private case {word.decode()}", where=name)
