"""Files that nobody should give: every kind of wrong content under every ending that c4s reads, and odd paths."""

from __future__ import annotations

import json
import os
from pathlib import Path

KINDS: dict[str, bytes] = {
    "empty": b"",
    "blank": b" \n\t\n",
    "cut": b'{"schema_version": "0.3.0", "actors": [',
    "binary": bytes(range(256)) * 8,
    "zeros": bytes(4096),
    "latin": '{"name": "Stra\xdfe", "client": "M\xe4rz"}'.encode("latin-1"),
    "utf16": json.dumps({"name": "a", "actors": []}).encode("utf-16"),
    "list": b"[]",
    "number": b"7",
    "null": b"null",
    "text": b'"just text"',
    "object": b"{}",
    "wrong": b'{"nosuch": 1}',
    "deep": b"[" * 100_000,
    "deepobject": b'{"a":' * 5_000 + b"1" + b"}" * 5_000,
    "nan": b'{"actors": NaN, "x": Infinity}',
    "bignumber": b'{"actors": ' + b"9" * 5_000 + b"}",
    "exponent": b'{"actors": 1e999}',
    "surrogate": b'{"actors": "\\ud800", "name": "\\udfff"}',
    "nul": b'{"actors": "a\\u0000b", "name": "a\\u0000b"}',
    "twice": b'{"actors": [], "actors": 7}',
    "tagged": b"!!python/object/apply:os.system ['true']\n",
    "anchors": b"a: &a [x, x]\nb: &b [*a, *a]\nc: *nosuch\n",
    "aliases": b"a0: &a0 x\n"
    + b"".join(b"a%d: &a%d [%s]\n" % (n, n, b", ".join([b"*a%d" % (n - 1)] * 10)) for n in range(1, 13)),
    "longnumber": b'{"client": 0x' + b"f" * 6_000 + b"}",
    "sexagesimal": b"client: " + b"1:" * 3_000 + b"1.5\n",
    "merges": b"a: [&a0 {k: 1}"
    + b"".join(b", &a%d {<<: [%s]}" % (n, b", ".join([b"*a%d" % (n - 1)] * 10)) for n in range(1, 13))
    + b"]\n",
    "tab": b"name:\n\t- x\n",
    "gzip": b"\x1f\x8b\x08\x00" + b"\x00" * 12,
    "html": b"<!DOCTYPE html><html><body>404</body></html>",
}
ENDINGS = (
    "json",
    "jsonl",
    "yaml",
    "yml",
    "sql",
    "csv",
    "sdf",
    "glb",
    "gltf",
    "obj",
    "dae",
    "parquet",
    "txt",
    "level.json",
)


def write_garbage(folder: Path) -> Path:
    """``KIND.ENDING`` for each, folders that hold them, and paths that are no files."""
    for kind, content in KINDS.items():
        for ending in ENDINGS:
            (folder / f"{kind}.{ending}").write_bytes(content)
        for name in ("outcome.json", "plan.json", "bundle.json", "task.yaml", "pack.json", "suite.json", "mesh.obj"):
            (folder / "in" / kind).mkdir(parents=True, exist_ok=True)
            (folder / "in" / kind / name).write_bytes(content)
    (folder / "folder").mkdir()
    for ending in ENDINGS:
        (folder / f"folder.{ending}").mkdir()
        os.mkfifo(folder / f"fifo.{ending}")
        (folder / f"dangling.{ending}").symlink_to("nowhere")
        (folder / f"loop.{ending}").symlink_to(f"loop.{ending}")
    return folder
