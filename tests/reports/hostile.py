"""A site whose every text from outside would break a page: markup, scripts, unseen and turning characters, length."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import pyarrow as pa
import pyarrow.parquet as pq

from reports.site import build_site
from warehouse.database import rebuild
from warehouse.scenes import packed, unpacked

MARKUP: Final = (
    '</script></pre><script>alert(1)</script><img src=x onerror=alert(2)>"><svg onload=alert(4)> '
    "javascript:alert(3) {{ 7 * 7 }}"
)
UNSEEN: Final = "\u202eevil\u2066 \0 \x1b[31m"
EVIL: Final = MARKUP + UNSEEN
LONG: Final = EVIL + "long" * 2500
SCRIPT: Final = f'import unreal\n# {MARKUP}\nname = "{MARKUP}"\nfor one in unreal.things():\n    print(one, 42)\n' * 20

TEXTS: Final = {
    "schedule": {"title": EVIL, "prompt": LONG, "model": EVIL},
    "outcomes": {"reason": LONG},
    "attempts": {"message": LONG, "client_version": EVIL, "engine_version": EVIL, "model": EVIL},
    "claims": {"text": EVIL, "reason": LONG, "kind": EVIL},
    "tool_use": {"tool": EVIL},
    "verdicts": {"reason": LONG},
}
"""Columns that are replaced, by table."""
SAID: Final = ("text", "reason", "message", "detail", "explanation")
"""Keys of verdict documents whose texts are replaced. Names of actors get an ending: they still name the same."""
NAMES: Final = ("actor", "label", "candidate", "subject", "name", "source_actor")

Row = dict[str, Any]


def make_hostile(played: Path, home: Path) -> None:
    """Write ``warehouse`` and ``site`` below ``home``: what was played, with hostile texts."""
    shutil.copytree(played / "warehouse", home / "warehouse")
    for table, texts in TEXTS.items():
        _change(home / "warehouse", table, lambda row, texts=texts: row | {k: v for k, v in texts.items() if row[k]})
    _change(home / "warehouse", "findings", lambda row: row | {"subject": row["subject"] + EVIL, "detail": LONG})
    _change(home / "warehouse", "calls", _call)
    _change(home / "warehouse", "scenes", _scene)
    _change(home / "warehouse", "verdicts", _verdict)
    _change(home / "warehouse", "pictures", lambda row: row | {"view": row["view"] + EVIL})
    rebuild(home / "warehouse")
    build_site(home / "warehouse", home / "site", played / "suites")


def _change(warehouse: Path, table: str, change: Callable[[Row], Row]) -> None:
    for path in (warehouse / table).rglob("*.parquet"):
        found = pq.ParquetFile(path).read()
        changed = [change(row) for row in found.to_pylist()]
        pq.write_table(pa.Table.from_pylist(changed, schema=found.schema), path)


def _call(row: Row) -> Row:
    """The first call of an attempt sends a script; all that was sent and answered is hostile."""
    made = row | {"answer": EVIL * 9, "arguments": EVIL}
    if row["call"] != 1:
        return made
    script = {"tool": "execute_python_script", "script": SCRIPT, "script_characters": 10_000_000}
    return made | script | {"outcome": "error", "error": EVIL}


def _scene(row: Row) -> Row:
    document = unpacked(row["document"])
    for actor in document["actors"]:
        actor |= {name: actor[name] + EVIL for name in ("name", "label", "asset") if actor.get(name)}
    for mesh in document["meshes"]:
        mesh[0] += EVIL
    for look in document["materials"]:
        look["path"] += EVIL
    return row | {"document": packed(document)}


def _verdict(row: Row) -> Row:
    return row | {"document": json.dumps(_spoilt(json.loads(row["document"])))}


def _spoilt(value: Any) -> Any:
    if isinstance(value, list):
        return [_spoilt(one) for one in value]
    if not isinstance(value, dict):
        return value
    return {key: _text(key, one) if isinstance(one, str) else _spoilt(one) for key, one in value.items()}


def _text(key: str, text: str) -> str:
    return EVIL if key in SAID and text else text + EVIL if key in NAMES and text else text
