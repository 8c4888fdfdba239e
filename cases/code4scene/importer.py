"""From published tasks to a suite: text-to-scene runs with proxy assets, image-to-scene needs its content."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import digest, read_json, write_json, write_text
from c4s.folders import beside, put_folder
from c4s.names import check_written
from c4s.protocol.graph.check import check_bundle
from c4s.protocol.settings import is_construction
from c4s.records.level import Level
from c4s.records.suite import SUITE, AgentCase, PackRef, SuiteFolder, WithheldCase, WithheldFolder
from cases.binding import freeze_binding, reviewed_beside
from cases.code4scene.needs import TaskNeeds, content_pack, listings, needs_of, read_table, told
from cases.code4scene.tasks import Task, find_tasks, palette, read_task
from cases.settle import to_build
from cases.veil import Veil
from catalog.proxy import build_proxy_pack
from catalog.settle import settle

MINIMUM_ACTORS = 1
"""The published tasks name no minimum; an empty scene fails."""


def import_code4scene(
    folder: Path,
    out: Path,
    packs_root: Path,
    progress: Callable[[str], None],
    *,
    content: Path | None = None,
    replace: bool = False,
) -> dict[str, Any]:
    """Import every task at or below ``folder`` as the suite ``out``; returns a report, one row a task.

    The report's ``needs`` says what the image tasks would need together. ``content`` is a table of content given for
    it (``cases.code4scene.needs``): its meshes become the pack ``content-<suite>`` under their published paths.
    Raises ``BadInput`` for a malformed task, recipe, table or requirement bundle, two tasks of one id, or where no task
    can be run; without ``replace`` also where another suite of this name, or another pack of a task, is there or was
    changed.
    """
    check_written(folder)
    tasks = [read_task(path) for path in find_tasks(folder)]
    for name, times in Counter(task.case_id.lower() for task in tasks).items():
        if times > 1:
            raise BadInput(f"task id {name!r} occurs twice, letter case aside", where=str(folder))
    notes = {task.case_id: _checked_bundle(task) for task in tasks}
    needs = {task.case_id: needs_of(task) for task in tasks if not is_construction(task.setting)}
    given = read_table(content, packs_root) if content is not None else None
    named = sorted({path for one in needs.values() for path in one.assets})
    with beside(out) as made, beside(packs_root / out.name) as made_packs:
        fresh = SuiteFolder(made / out.name)
        rows, packs = _cases(tasks, notes, needs, fresh, made_packs, progress)
        if not packs:
            lacking = sorted({pack for one in needs.values() for pack in one.packs})
            raise BadInput(
                f"none of these tasks can be run without its content: the packs {', '.join(lacking) or '-'}",
                where=str(folder),
                todo="image-to-scene tasks need their Unreal levels",
            )
        stand_in = content_pack(given, named, packs_root, made_packs, f"content-{out.name}") if given else None
        suite = fresh.freeze(out.name, f"Imported from {folder.name}", "Published tasks with proxy assets", packs)
        same = not replace and (out / SUITE).is_file() and SuiteFolder(out).suite() == suite
        wanted = to_build(out, same=same, replace=replace)
        for pack_id in [pack.pack_id for pack in packs] + ([stand_in.pack_id] if stand_in else []):
            settle(made_packs / pack_id, packs_root / pack_id, replace=replace)
        if wanted:
            put_folder(fresh.root, out, marker=SUITE)
    return {
        "suite": suite.suite_id,
        "sha256": suite.sha256(),
        "folder": str(out),
        "runnable": len(packs),
        "cases": rows,
        "needs": told(list(needs.values()), given, listings(folder)),
        "content_pack": stand_in.pack_id if stand_in else None,
    }


def _checked_bundle(task: Task) -> str:
    """What the report says of a task's bundle; ``BadInput`` for one that cannot be used, or of another prompt."""
    if task.bundle is None:
        return "no requirement bundle, so Detailed Alignment is not evaluated"
    bundle = read_json(task.bundle, what="requirement bundle")
    report = check_bundle(bundle)
    report.refuse(where=str(task.bundle))
    if bundle["graph"]["prompt"].strip() != task.prompt.strip():
        raise BadInput("this requirement bundle is of another prompt than its task", where=str(task.bundle))
    warnings = [f"{warning.place}: {warning.message}" for warning in report.warnings]
    more = f" and {len(warnings) - 1} more" if len(warnings) > 1 else ""
    return f"bundle warning: {warnings[0]}{more}" if warnings else ""


def _cases(
    tasks: list[Task],
    notes: dict[str, str],
    needs: dict[str, TaskNeeds],
    suite: SuiteFolder,
    packs_root: Path,
    progress: Callable[[str], None],
) -> tuple[list[dict[str, Any]], list[PackRef]]:
    """Write the cases that can be run, and their packs under ``packs_root``; a report row a task."""
    veil = Veil(digest([task.case_id for task in tasks]))
    rows: list[dict[str, Any]] = []
    packs: list[PackRef] = []
    for task in tasks:
        if is_construction(task.setting):
            pack, count = _text_case(task, veil.alias(task.case_id), suite, packs_root, progress)
            packs.append(pack)
            rows.append(
                {
                    "case_id": task.case_id,
                    "setting": task.setting,
                    "assets": count,
                    "runnable": True,
                    "note": "; ".join(filter(None, ("proxy assets", notes[task.case_id]))),
                }
            )
        else:
            rows.append(
                {
                    "case_id": task.case_id,
                    "setting": task.setting,
                    "assets": None,
                    "runnable": False,
                    "note": f"needs the levels and content of {', '.join(needs[task.case_id].packs) or 'its packs'}",
                    "needs": asdict(needs[task.case_id]),
                }
            )
    return rows, packs


def _text_case(
    task: Task, alias: str, suite: SuiteFolder, packs_root: Path, progress: Callable[[str], None]
) -> tuple[PackRef, int]:
    entries = palette(task)
    pack = build_proxy_pack(f"proxy-{alias}", f"Proxies for {task.case_id}", entries, packs_root, progress)
    reference = PackRef(pack_id=pack.pack_id, digest=pack.sha256())
    agent, withheld = suite.agent(alias), suite.withheld(task.case_id)
    AgentCase(
        alias=alias,
        setting=task.setting,
        prompt=task.prompt,
        start_map=task.start_map,
        budget=task.budget,
        packs=[reference],
        catalog=[entry.path for entry in entries],
        plate_m=task.plate_m,
    ).write(agent / "case.json")
    Level(package=task.start_map).write(agent / "start.level.json")
    WithheldCase(
        case_id=task.case_id,
        alias=alias,
        title=task.case_id,
        scene_id=task.packs[0] if task.packs else task.case_id,
        minimum_actors=MINIMUM_ACTORS,
        proxy_assets=True,
    ).write(withheld / "case.json")
    write_text(withheld / "prompt.txt", task.prompt)
    if task.bundle is not None:
        folder = WithheldFolder(withheld)
        shutil.copyfile(task.bundle, folder.requirements)
        bundle = read_json(folder.requirements, what="requirement bundle")
        freeze_binding(folder, bundle, [pack], reviewed_beside(task.bundle))
    write_json(withheld / "source.json", {"layout": "code4scene", "packs": list(task.packs)})
    return reference, len(entries)
