"""A site of made results: planted abilities, both panels, zeros, gaps, repeats, and texts that would break a page."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pyarrow as pa
import pyarrow.parquet as pq

from bench.made_warehouse import MadeWarehouse
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTINGS
from reports.site import build_site
from tests.reports.kinds import make_status
from warehouse.database import rebuild

HOSTILE: Final = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'{{ 7 * 7 }}\u202e"
SHAPE: Final = ((SETTINGS[0], 12, 12), (INDOOR_REPAIR, 14, 7), (OUTDOOR_REPAIR, 14, 7))
PRIVATE: Final = frozenset(
    f"{setting.rpartition('/')[2]}-{place:02d}" for setting, count, _ in SHAPE for place in range(count - 5, count + 1)
)


def make_site(home: Path) -> None:
    """Write ``warehouse`` and ``site`` below ``home``."""
    made = MadeWarehouse(
        home / "warehouse",
        (0.75, 0.7, 0.6, 0.55, 0.4),
        shape=SHAPE,
        repeats=2,
        private=PRIVATE,
        zeros={("agent-03", "text-to-scene-02"): "forbidden_asset"},
        pending=frozenset({("agent-05", "text-to-scene-01")}),
        documents=True,
    )
    made.write()
    relabel(made.root, "title", "text-to-scene-03", HOSTILE)
    relabel(made.root, "prompt", "text-to-scene-03", HOSTILE)
    rebuild(made.root)
    build_site(made.root, home / "site")
    make_status(home)


def relabel(warehouse: Path, column: str, case: str, text: str) -> None:
    """Give a case another text in the whole schedule."""
    for path in (warehouse / "schedule").rglob("*.parquet"):
        table = pq.ParquetFile(path).read()
        texts = [
            text if row == case else old
            for row, old in zip(table["case_id"].to_pylist(), table[column].to_pylist(), strict=True)
        ]
        place = table.column_names.index(column)
        pq.write_table(table.set_column(place, table.schema.field(column), pa.array(texts, pa.string())), path)
