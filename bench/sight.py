"""Stage 2 on large cases: the time to plan a scene's views and take all pictures, and the memory of both processes.

``python -m bench.sight --sheet OUT.png [EVIDENCE ...]`` draws the planned views of evidence folders, each with the
actors that its claim needs outlined; without a folder, of the scenes that the oracle saves in the starter texts.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageDraw

from bench.row import Row
from bench.town import write_town
from c4s.evidence import open_level
from c4s.files import read_json
from c4s.home import packs_root, suites_root
from c4s.protocol.bundle import read_requirements
from c4s.records.captures import OVERVIEW, Captures, View
from c4s.records.evidence import catalog_facts
from c4s.records.folder import EvidenceFolder
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.semantics.sight import sight_plan
from cases.starter.suite import SUITE_ID, build_starter
from catalog.build import ensure_pack

TEXTS = ("text-flat-family", "text-office-open-plan", "text-small-farm", "text-harbour-street")
LARGEST, REQUIREMENTS = "text-harbour-street", 58
TOWN, ACTORS = "c4s-home", 3000
_GOAL_S, _GOAL_MIB = 60.0, 2048.0
_CELL = (480, 270)
_ACROSS = 4
_LINE = (255, 0, 255)


def _starter() -> SuiteFolder:
    root = suites_root() / SUITE_ID
    build_starter(root, packs_root(), lambda line: print(line, file=sys.stderr))
    return SuiteFolder(root)


def _looked(level: Path, packs: Sequence[Path], bundle: Any, out: Path) -> Captures:
    catalog = catalog_facts(Pack.read(folder / MANIFEST) for folder in packs)
    with open_level(engine="headless", packs=packs, level=level) as clean:
        clean.export(out)
        clean.look(out, sight_plan(read_requirements(bundle), catalog))
    return Captures.read(EvidenceFolder(out).captures_index)


def _case(suite: SuiteFolder, case_id: str) -> tuple[WithheldFolder, list[Path]]:
    packs = suite.agent_case(suite.withheld_case(case_id).alias).packs
    return WithheldFolder(suite.withheld(case_id)), [packs_root() / pack.pack_id for pack in packs]


def _repeated(bundle: dict[str, Any], number: int) -> dict[str, Any]:
    """A bundle whose last requirements are asked again until it has so many."""
    graph, rows = bundle["graph"], list(bundle["requirements"])
    nodes, edges = list(graph["nodes"]), list(graph["edges"])
    own = {node["id"]: node for node in nodes}
    for again, row in enumerate(reversed(bundle["requirements"])):
        if len(rows) >= number:
            break
        node = f"{row['node_id']}_{again}"
        nodes.append({**own[row["node_id"]], "id": node})
        edges += [{**edge, "source_id": node} for edge in edges if edge["source_id"] == row["node_id"]]
        rows.append({**row, "node_id": node})
    return {**bundle, "requirements": rows, "graph": {**graph, "nodes": nodes, "edges": edges}}


def measured(what: str) -> dict[str, Any]:
    """One case, in this process: its wall-clock seconds with the engine's start, its views, the peak memory in MiB."""
    suite = _starter()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if what == "town":
            withheld, packs = _case(suite, TEXTS[0])
            level = write_town(folder, ensure_pack(TOWN, packs_root()), ACTORS)
            bundle = read_json(withheld.requirements)
        else:
            withheld, packs = _case(suite, LARGEST)
            level, bundle = withheld.truth_level, _repeated(read_json(withheld.requirements), REQUIREMENTS)
        started = time.perf_counter()
        captures = _looked(level, packs, bundle, folder / "looked")
        seconds = time.perf_counter() - started
    usage = [resource.getrusage(who).ru_maxrss / 1024 for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return {
        "seconds": round(seconds, 2),
        "views": len(captures.views),
        "claims": len(captures.claims),
        "requirements": len(bundle["requirements"]),
        "peak_mib": round(sum(usage), 1),
    }


def rows() -> list[Row]:
    """The largest starter text with 58 requirements, and a town of 3,000 actors; each in a process of its own."""
    found = {}
    for what in ("street", "town"):
        command = [sys.executable, "-m", "bench.sight", "--one", what]
        found[what] = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    street, town = found["street"], found["town"]
    return [
        Row(
            f"sight, {street['requirements']} requirements, {street['views']} views, engine start included",
            street["seconds"],
            f"under {_GOAL_S:.0f} s",
            street["seconds"] < _GOAL_S,
        ),
        Row(
            f"sight, {ACTORS} actors, {town['views']} views: peak of engine and planner ({town['seconds']} s)",
            town["peak_mib"],
            f"under {_GOAL_MIB:.0f} MiB",
            town["peak_mib"] < _GOAL_MIB,
            unit="MiB",
        ),
    ]


def _drawn(folder: EvidenceFolder, captures: Captures) -> Iterator[Image.Image]:
    """The overview and claim views with what they were taken for."""
    for view in [*captures.of(OVERVIEW), *captures.of("claim")]:
        users = [claim for claim, found in captures.claims.items() if view.name in found.primary]
        own = [claim for claim in users if captures.claims[claim].primary[0] == view.name]
        users = own or users or [claim for claim, found in captures.claims.items() if view.name in found.alternate]
        wanted = set(captures.claims[users[0]].targets) if users and view.purpose == "claim" else set()
        picture = _outlined(folder, view, wanted)
        title = f"{view.name}  {users[0] if users and wanted else ''}"
        ImageDraw.Draw(picture).text((6, 4), title, fill=(255, 255, 255), stroke_width=2, stroke_fill=(0, 0, 0))
        yield picture


def _outlined(folder: EvidenceFolder, view: View, wanted: set[str]) -> Image.Image:
    with Image.open(folder.captures / view.file) as file:
        pixels = np.asarray(file.convert("RGB")).copy()
    if view.actors is not None and wanted:
        mask = np.load(folder.captures / view.actors)
        numbers = [number for number, name in enumerate(mask["names"].tolist()) if name in wanted]
        shown = np.where(np.isin(mask["actor"], numbers), mask["actor"], -1)
        edge = np.zeros(shown.shape, dtype=bool)
        edge[1:] |= shown[1:] != shown[:-1]
        edge[:, 1:] |= shown[:, 1:] != shown[:, :-1]
        pixels[edge] = _LINE
    return Image.fromarray(pixels).resize(_CELL)


def sheet(out: Path, folders: Sequence[Path]) -> None:
    """Draw the views of evidence folders under each other."""
    lines = []
    for folder in map(EvidenceFolder, folders):
        pictures = list(_drawn(folder, Captures.read(folder.captures_index)))
        lines += [pictures[first : first + _ACROSS] for first in range(0, len(pictures), _ACROSS)]
    whole = Image.new("RGB", (_ACROSS * _CELL[0], len(lines) * _CELL[1]))
    for row, line in enumerate(lines):
        for column, picture in enumerate(line):
            whole.paste(picture, (column * _CELL[0], row * _CELL[1]))
    whole.save(out)


def _of_the_oracle(out: Path) -> list[Path]:
    suite, found = _starter(), []
    for case_id in TEXTS:
        withheld, packs = _case(suite, case_id)
        _looked(withheld.truth_level, packs, read_json(withheld.requirements), out / case_id)
        found.append(out / case_id)
    return found


def main() -> None:
    """Draw a sheet, or measure one case for ``rows``."""
    parser = argparse.ArgumentParser(prog="python -m bench.sight", description=__doc__)
    parser.add_argument("--sheet", type=Path)
    parser.add_argument("--one", choices=("street", "town"))
    parser.add_argument("evidence", nargs="*", type=Path)
    given = parser.parse_args()
    if given.one:
        print(json.dumps(measured(given.one)))
    elif given.sheet:
        with tempfile.TemporaryDirectory() as name:
            sheet(given.sheet, given.evidence or _of_the_oracle(Path(name)))
    else:
        parser.error("give --sheet OUT.png, or run python -m bench sight")


if __name__ == "__main__":
    main()
