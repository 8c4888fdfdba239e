"""The starter suite: four packs, four scenes, texts and repairs indoors and outdoors, all made by this project."""

from __future__ import annotations

import argparse
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from c4s.home import packs_root, suites_root
from c4s.records.suite import Suite
from cases.model import SuiteDefinition
from cases.starter import indoor_cases, outdoor_cases
from cases.suite import Progress, build_suite
from catalog.build import ensure_pack
from catalog.starter import STARTER

SUITE_ID = "starter"
PACKS_AT_ONCE = 2
"""One pack's meshes are made while the previews of another wait for the renderer to be compiled, or are drawn."""


def definition() -> SuiteDefinition:
    """Scenes and cases of the suite."""
    indoor, outdoor = indoor_cases.scenes(), outdoor_cases.scenes()
    return SuiteDefinition(
        SUITE_ID,
        "Starter suite",
        "Made for c4s: an office, a flat, a harbour street and a small farm, with texts to build and damage to repair.",
        tuple(STARTER),
        (*indoor, *outdoor),
        (*indoor_cases.cases(indoor), *outdoor_cases.cases(outdoor)),
    )


def build_packs(root: Path, progress: Progress = print, *, replace: bool = False) -> None:
    """Build the four packs under ``root`` where they are not there yet; the same sources give the same bytes."""

    def build(pack_id: str) -> None:
        progress(f"pack {pack_id}")
        ensure_pack(pack_id, root, replace=replace)

    with ThreadPoolExecutor(PACKS_AT_ONCE) as pool:
        list(pool.map(build, STARTER))


def build_starter(root: Path, packs: Path, progress: Progress = print, *, replace: bool = False) -> Suite:
    """Build the packs under ``packs``, then the suite at ``root``; what is there already stays.

    Raises ``BadInput`` where something else of these names is there, or something that was changed, unless ``replace``
    is given.
    """
    build_packs(packs, progress, replace=replace)
    return build_suite(definition(), root, packs, progress, replace=replace)


def main() -> None:
    """``python -m cases.starter.suite``: build everything under ``C4S_HOME``."""
    parser = argparse.ArgumentParser(description="Build the starter packs and suite.")
    parser.add_argument("--out", type=Path, default=None, help="suite folder (default: under C4S_HOME)")
    parser.add_argument("--replace", action="store_true", help="replace other packs and another suite of these names")
    options = parser.parse_args()
    suite = build_starter(options.out or suites_root() / SUITE_ID, packs_root(), replace=options.replace)
    print(f"{suite.suite_id}: {len(suite.cases)} cases, {suite.sha256()[:12]}")


if __name__ == "__main__":
    main()
