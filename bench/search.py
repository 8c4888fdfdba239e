"""Search by meaning: recall of labelled queries over packs, by half, and what a search costs.

The queries (``tests/toolbox/pack_queries.yaml``) share no word with the assets that they mean; every second one was set
aside while the blend was tuned. The packs are the four that the starter suite is built with and, where the folder
``shared`` lies beside the checkout, the seven of ``shared/assets/packs``, with names and tags as ``c4s catalog build``
makes them.

    python -m bench search
"""

from __future__ import annotations

import fnmatch
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import yaml

from bench.row import Row
from c4s.records.pack import Asset, Pack
from c4s.toolbox.catalog import CaseCatalog, CatalogEntry
from catalog.build import starter_pack
from catalog.ingest.vocabulary import kind_of, readable, search_words
from catalog.shapes.spec import asset_id
from catalog.starter import STARTER

ROOT = Path(__file__).resolve().parent.parent
QUERIES = ROOT / "tests/toolbox/pack_queries.yaml"
SHARED_PACKS = ROOT.parent / "shared/assets/packs"
MESHES = (".gltf", ".glb", ".obj")
AT, FLOOR, GOAL_S = 5, 0.9, 1.0
REPEATS = 20
HALVES = ("tuned", "held out")
Query = dict[str, Any]


def asset(name: str, category: str, description: str, tags: list[str]) -> Asset:
    """An asset as a pack's builder names it, of no size."""
    return Asset(
        id=re.sub(r"\W", "_", asset_id(name)),
        name=readable(name),
        category=category,
        tags=tags,
        path=f"/Game/T/SM_{name}.SM_{name}",
        description=description,
        bounds_min_cm=(0, 0, 0),
        bounds_max_cm=(1, 1, 1),
    )


def catalog_of(assets: list[Asset]) -> CaseCatalog:
    """A catalog of some assets that lie in no folder."""
    pack = Pack(pack_id="t", content_folder="T", title="T", license="-", assets=[])
    return CaseCatalog([CatalogEntry(one, pack, Path()) for one in assets])


def starter_assets(pack: str) -> list[Asset]:
    """The assets of a starter pack."""
    specs = starter_pack(pack).assets
    return [asset(spec.name, spec.category, spec.description, list(spec.tags)) for spec in specs]


def shared_assets(folder: Path) -> list[Asset]:
    """The assets that the meshes of a folder become."""
    names = sorted({path.stem for path in folder.rglob("*") if path.suffix in MESHES})
    return [asset(name, kind_of(name) or "other", "", search_words(name)) for name in names]


def pack_catalogs() -> Iterator[tuple[str, CaseCatalog, list[Query]]]:
    """Each pack that is here with its catalog and its queries."""
    for pack, queries in yaml.safe_load(QUERIES.read_text(encoding="utf-8")).items():
        folder = SHARED_PACKS / pack
        if pack in STARTER:
            yield pack, catalog_of(starter_assets(pack)), queries
        elif folder.is_dir():
            yield pack, catalog_of(shared_assets(folder)), queries


def answers(catalog: CaseCatalog, query: Query) -> set[str]:
    """Ids of the assets that a query means."""
    return {one.id for one in catalog.assets if any(fnmatch.fnmatch(one.id, pattern) for pattern in query["answers"])}


def found_share(catalog: CaseCatalog, query: Query) -> float:
    """Share of the answers (of ``AT`` at most) that are among the first ``AT`` results."""
    wanted = answers(catalog, query)
    found = {row["id"] for row in catalog.search(query["query"], limit=AT)}
    return len(found & wanted) / min(AT, len(wanted))


def half(query: Query) -> str:
    """The half of the queries that one is in."""
    return HALVES[bool(query.get("held"))]


def first_search_s() -> float:
    """Seconds from a fresh process's first import of the catalog to its first answer; vectors are kept already."""
    script = (
        "import time; start = time.perf_counter(); from bench import search;"
        "search.catalog_of(search.starter_assets('c4s-farm')).search('swine'); print(time.perf_counter() - start)"
    )
    return float(subprocess.run([sys.executable, "-c", script], capture_output=True, check=True, cwd=ROOT).stdout)


def _seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def _recall(name: str, shares: list[float]) -> Row:
    """A row for a half, which has a goal, or for a pack, which is shown."""
    mean = sum(shares) / len(shares)
    goal = f"at least {FLOOR:g}" if name in HALVES else "shown"
    return Row(f"recall at {AT}, {name}, {len(shares)} queries", mean, goal, name not in HALVES or mean >= FLOOR, "")


def rows() -> list[Row]:
    """Recall at five by half and by pack, and the time of searches."""
    shares: dict[str, list[float]] = {}
    with tempfile.TemporaryDirectory() as home:
        os.environ["C4S_HOME"] = home
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        makes = []
        catalog: CaseCatalog | None = None
        for pack, catalog, queries in pack_catalogs():
            makes.append(_seconds(partial(catalog.search, "swine")))
            for query in queries:
                share = found_share(catalog, query)
                shares.setdefault(half(query), []).append(share)
                shares.setdefault(pack, []).append(share)
        assert catalog is not None
        mebibytes = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
        spent = sorted(_seconds(partial(catalog.search, "somewhere soft to lie down")) for _ in range(REPEATS))
        first = first_search_s()
    return [
        *(_recall(name, found) for name, found in sorted(shares.items(), key=lambda pair: pair[0] not in HALVES)),
        Row("first search of a pack ever", sorted(makes)[len(makes) // 2], "shown", True),
        Row("first search of a process", first, f"under {GOAL_S:g} s", first < GOAL_S),
        Row("a search after that", 1000 * spent[REPEATS // 2], "under 100 ms", spent[REPEATS // 2] < 0.1, "ms"),
        Row("memory that searching adds", mebibytes, "under 250 MiB", mebibytes < 250, "MiB"),
    ]
