"""Answers that were given before, by what was asked: ``C4S_HOME/cache/judge``. It may be deleted at any time.

The key is a digest of the judge (its configuration and prompts) and of the request (its text, the digests of its
pictures, its schema). Only answers that keep their contract are kept, so a judge that was killed goes on with the ones
it has.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import digest, read_json, write_json
from c4s.home import cache_root
from c4s.judge.model.requests import Request


@dataclass(frozen=True)
class Cache:
    """The answers to one judge's requests."""

    judge: str
    """Digest of its configuration and prompts."""
    root: Path | None = None
    """Another folder than the one that all runs share."""

    def get(self, request: Request) -> dict[str, Any] | None:
        """The answer's record; None where there is none, or none that can be read."""
        try:
            found = read_json(self._file(request), what="answer")
        except BadInput:
            return None
        return found if isinstance(found, dict) and found.get("request_sha256") == request.sha256 else None

    def put(self, request: Request, answer: dict[str, Any]) -> None:
        """Keep an answer."""
        write_json(self._file(request), {"request_sha256": request.sha256, **answer}, indent=None)

    def _file(self, request: Request) -> Path:
        key = digest([self.judge, request.sha256])
        return (self.root or cache_root() / "judge") / key[:2] / f"{key}.json"
