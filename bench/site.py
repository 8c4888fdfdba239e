"""The site of a night: how long its pages take to be made, how large they are, how soon they are seen.

    python -m bench.site [--configurations 14] [--cases 190] [--from HOME] [--keep FOLDER]
    python -m bench.site --site FOLDER

Results are made (``bench/made_warehouse.py``); calls, verdicts, pictures and scenes are those of real trials, one a
setting (``bench/made_shown.py``): of a home where the planner did the starter suite, else of a suite that is played
first. The site is built from nothing, again with nothing changed, and again with one trial judged anew, each in a
process of its own. ``--site`` measures a site that is there.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

import pyarrow as pa
import pyarrow.parquet as pq

from bench.first_paint import PageSeen, seen
from bench.made_shown import ShownRows, play
from bench.made_warehouse import SUITE, MadeWarehouse
from bench.row import Row
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTINGS, Setting
from warehouse.database import rebuild

GOAL_PAINT_S, GOAL_FIRST_BYTES, GOAL_PAGE_BYTES = 1.0, 500_000, 3_000_000
GOAL_BUILD_S, GOAL_AGAIN_S = 1800.0, 300.0
"""Wall time of a whole build, and of one after a trial has changed, for 14 configurations on 190 cases."""
NUDGE: Final = 1e-6
SHARES: Final = {SETTINGS[0]: (4, 19), INDOOR_REPAIR: (5, 19), OUTDOOR_REPAIR: (10, 19)}
"""Of the cases: those of the paper's public set."""
KINDS: Final = {"leaderboard": "index.html", "cases": "boards/*--cases--*", "compare": "boards/*--compare--*"} | {
    "configuration": "agents/*.html",
    "case": "cases/*.html",
    "trial": "trials/*.html",
}


@dataclass(frozen=True)
class BuildTime:
    """One build, in a process of its own."""

    wall_s: float
    cpu_s: float
    memory_mb: float
    """Resident, at most."""
    written: int
    """Pages that were not there before, or are other files now."""


@dataclass(frozen=True)
class SiteSize:
    """What lies in a site's folder."""

    bytes: int
    files: int
    pages: int
    largest_page_bytes: int
    largest_page: str
    by_kind: dict[str, int]
    """Bytes of files by folder."""


def shape_of(cases: int) -> list[tuple[Setting, int, int]]:
    """So many cases of the three settings, two a source scene."""
    counts = {setting: cases * share // whole for setting, (share, whole) in SHARES.items()}
    counts[OUTDOOR_REPAIR] += cases - sum(counts.values())
    return [(setting, count, max(1, count // 2)) for setting, count in counts.items()]


def made_night(root: Path, donor: Path, configurations: int, cases: int) -> MadeWarehouse:
    """Write a night's warehouse."""
    abilities = [0.75 - 0.4 * place / configurations for place in range(configurations)]
    made = MadeWarehouse(root, abilities, shape=shape_of(cases))
    made.write()
    ShownRows(donor).write(made)
    return made


def judge_anew(made: MadeWarehouse) -> None:
    """A slightly other score for the first trial of the first configuration, which changes no order."""
    path = made.root / "outcomes" / f"suite={SUITE}" / f"configuration={made.names()[0]}" / f"{made.judges[0]}.parquet"
    table = pq.ParquetFile(path).read()
    scores = table["score"].to_pylist()
    scores[0] += NUDGE if scores[0] < 0.5 else -NUDGE
    place = table.column_names.index("score")
    pq.write_table(table.set_column(place, table.schema.field("score"), pa.array(scores)), path, compression="zstd")
    rebuild(made.root)


def build(warehouse: Path, site: Path) -> BuildTime:
    """Build the site in another process."""
    before = _pages(site)
    command = [sys.executable, "-m", "bench.site", "--build", str(warehouse), str(site)]
    told = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return BuildTime(**told, written=len(_pages(site).items() - before.items()))


def _build_here(warehouse: Path, site: Path) -> None:
    from reports.site import build_site

    begun = time.perf_counter()
    build_site(warehouse, site)
    used = resource.getrusage(resource.RUSAGE_SELF)
    told = {"wall_s": time.perf_counter() - begun, "cpu_s": used.ru_utime + used.ru_stime}
    print(json.dumps({**told, "memory_mb": used.ru_maxrss / 1024}))


def _pages(site: Path) -> dict[str, int]:
    return {str(path.relative_to(site)): path.stat().st_ino for path in site.rglob("*.html")}


def size_of(site: Path) -> SiteSize:
    """What lies in the folder."""
    sizes = {path.relative_to(site): path.stat().st_size for path in site.rglob("*") if path.is_file()}
    pages = {path: size for path, size in sizes.items() if path.suffix == ".html"}
    largest = max(pages, key=lambda path: pages[path])
    kinds: Counter[str] = Counter()
    for path, size in sizes.items():
        kinds[path.parts[0] if len(path.parts) > 1 else "."] += size
    return SiteSize(
        sum(sizes.values()), len(sizes), len(pages), pages[largest], str(largest), dict(kinds.most_common())
    )


def opened(site: Path) -> dict[str, PageSeen]:
    """The largest page of each kind, as a browser sees it."""
    largest = {
        kind: max(site.glob(pattern), key=lambda path: path.stat().st_size)
        for kind, pattern in KINDS.items()
        if any(site.glob(pattern))
    }
    return seen(largest)


@contextmanager
def _donor(home: Path | None) -> Iterator[Path]:
    if home is not None:
        yield home / "warehouse"
        return
    with tempfile.TemporaryDirectory() as scratch:
        yield play(Path(scratch))


def measured(
    configurations: int, cases: int, home: Path | None = None, keep: Path | None = None
) -> tuple[dict[str, BuildTime], SiteSize, dict[str, PageSeen]]:
    """Make a night and its site: what the builds took, how large it is, how its pages are seen."""
    with tempfile.TemporaryDirectory() as scratch, _donor(home) as donor:
        root = Path(scratch) if keep is None else keep
        made = made_night(root / "warehouse", donor, configurations, cases)
        site = root / "site"
        builds = {"from nothing": build(made.root, site), "nothing changed": build(made.root, site)}
        judge_anew(made)
        builds["one trial judged anew"] = build(made.root, site)
        return builds, size_of(site), opened(site)


def _rows_of(size: SiteSize, pages: dict[str, PageSeen], what: str) -> list[Row]:
    first = pages["leaderboard"]
    heaviest = max(pages, key=lambda kind: pages[kind].loaded_bytes)
    most = max(size.largest_page_bytes, pages[heaviest].loaded_bytes)
    paint, loaded = first.first_paint_s, first.loaded_bytes
    return [
        Row(f"first paint of the first page, {what}", paint, f"under {GOAL_PAINT_S:g} s", paint < GOAL_PAINT_S),
        Row(f"first page and its files, {what}", loaded / 1e3, "under 500 KB", loaded < GOAL_FIRST_BYTES, "KB"),
        Row(f"largest page ({heaviest}) and its files, {what}", most / 1e6, "under 3 MB", most < GOAL_PAGE_BYTES, "MB"),
    ]


def rows(configurations: int = 14, cases: int = 19) -> list[Row]:
    """A tenth of a night."""
    builds, size, pages = measured(configurations, cases)
    what = f"{configurations} x {cases}"
    goals = {"from nothing": GOAL_BUILD_S, "nothing changed": GOAL_AGAIN_S, "one trial judged anew": GOAL_AGAIN_S}
    return [
        *(
            Row(f"site of {what}, {name} (cpu)", one.cpu_s, f"under {goals[name]:g} s", one.cpu_s < goals[name])
            for name, one in builds.items()
        ),
        *_rows_of(size, pages, what),
    ]


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure and print; 1 where a goal is missed."""
    parser = argparse.ArgumentParser(prog="python -m bench.site", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--configurations", type=int, default=14)
    parser.add_argument("--cases", type=int, default=190)
    parser.add_argument("--from", dest="home", type=Path, help="a home where the planner did the starter suite")
    parser.add_argument("--keep", type=Path, help="leave warehouse and site in this new folder")
    parser.add_argument("--site", type=Path, help="measure this site, and build none")
    parser.add_argument("--build", nargs=2, type=Path, help=argparse.SUPPRESS)
    given = parser.parse_args(arguments)
    if given.build:
        _build_here(*given.build)
        return 0
    told: dict[str, Any] = {}
    if given.site:
        size, pages = size_of(given.site), opened(given.site)
    else:
        builds, size, pages = measured(given.configurations, given.cases, given.home, given.keep)
        told["builds"] = {name: asdict(one) for name, one in builds.items()}
    goals = _rows_of(size, pages, "this site")
    told |= {"size": asdict(size), "pages": {name: asdict(one) for name, one in pages.items()}}
    print(json.dumps(told | {"goals": {row.name: row.met for row in goals}}, indent=1))
    return 0 if all(row.met for row in goals) else 1


if __name__ == "__main__":
    sys.exit(main())
