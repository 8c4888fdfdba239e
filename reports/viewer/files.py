"""The files that the viewer loads: scripts that hand over one piece of data each, named by its digest.

Pages are opened from a folder, where a script can load other scripts and nothing else.
"""

from __future__ import annotations

import base64
from collections.abc import Iterable
from typing import Any, Final

from c4s.files import digest_bytes
from reports.frame import Board, SiteContext
from reports.frame.asked import of_case, text
from reports.viewer.three import LICENCE, three_script
from warehouse.database import rows
from warehouse.scenes import packed

FOLDER: Final = "scene"
DIGITS: Final = 20


def three_file(site: SiteContext) -> str:
    """three.js on the site, with its licence beside it; returns its path."""
    script = three_script()
    stem = f"{FOLDER}/three-{digest_bytes(script)[:DIGITS]}"
    site.put(f"{stem}.LICENSE.txt", LICENCE.encode())
    return site.put(f"{stem}.js", script)


def data_file(site: SiteContext, data: bytes) -> tuple[str, str]:
    """A script that hands over bytes, as base64, under the start of their digest; returns that name and its path."""
    name = digest_bytes(data)[:DIGITS]
    script = f'c4sScene.put("{name}","{base64.b64encode(data).decode()}");\n'
    return name, site.put(f"{FOLDER}/{name}.js", script.encode())


def json_file(site: SiteContext, value: dict[str, Any]) -> tuple[str, str]:
    """The same of a value as raw deflate of its JSON."""
    return data_file(site, packed(value))


def scenes_of(site: SiteContext, board: Board, case_id: str) -> dict[tuple[str, str], dict[str, Any]]:
    """Scenes of a public case by (trial, role); those of the case itself have no trial."""
    asked = f"SELECT trial_id, role, views, document FROM scenes WHERE {of_case(board, case_id)}"
    return {(row["trial_id"], row["role"]): row for row in rows(site.warehouse, asked)}


def shape_files(site: SiteContext, board: Board, wanted: Iterable[str]) -> dict[str, tuple[str, int]]:
    """Put the meshes and textures of these digests on the site: by digest the name and size of each that is kept."""
    names = ", ".join(sorted(text(sha256) for sha256 in set(wanted)))
    if not names:
        return {}
    asked = f"SELECT shape_sha256, data FROM shapes WHERE suite = {text(board.suite)} AND shape_sha256 IN ({names})"
    return {
        row["shape_sha256"]: (data_file(site, row["data"])[0], len(row["data"])) for row in rows(site.warehouse, asked)
    }
