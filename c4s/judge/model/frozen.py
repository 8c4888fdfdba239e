"""Stored requests as they are sent again: the same words, the same pictures, the same schema, in the stored order."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from c4s.errors import BadInput
from c4s.files import digest, read_json
from c4s.judge.model.batches import Batch
from c4s.judge.model.claims import claims_text, sheets_in
from c4s.judge.model.clerk import exchange_file
from c4s.judge.model.requests import Document, Request, claim_names, view_names
from c4s.judge.model.rungs import Sighted
from c4s.judge.model.schemas import claims_schema
from c4s.judge.model.sights import Sights
from c4s.records.judgement import Asked

_JUDGE_AGAIN: Final = "judge the trial again (the flow `rejudge`: docs/judge.md)"


def stored_request(asked: Asked, exchanges: Path, sights: Sights) -> Request:
    """A request of a schedule, with its pictures from the stored evidence.

    ``BadInput`` for a request that is not there as it was stored, and for a picture that is another one than it showed.
    """
    file = exchange_file(exchanges, asked.request_sha256)
    document = read_json(file, what="request")
    if not isinstance(document, dict) or digest(document) != asked.request_sha256:
        raise BadInput("the request has changed since it was stored", where=str(file), todo=_JUDGE_AGAIN)
    pictures = {}
    for name in asked.views:
        picture = sights.picture(name) if name in sights.views else None
        if picture is not None:
            pictures[picture.sha256] = picture.url
    request = Request(asked.purpose, document, pictures, tuple(asked.views), tuple(asked.claims))
    missing = request.shown() - pictures.keys()
    if missing:
        raise BadInput(
            f"the pictures of this request are not those of the evidence: {', '.join(sorted(missing))[:100]}",
            where=str(file),
            todo=_JUDGE_AGAIN,
        )
    return request


def asked_anew(request: Request, rung: Sighted, left: Batch, broken: Mapping[str, str]) -> Request:
    """What the ladder asks after an answer that broke its contract: the same, of the claims that are left."""
    sheets = dict(zip(request.claims, sheets_in(_text(request.document)), strict=True))
    names = claim_names(len(left.claims))
    kept = [{**sheets[claim], "claim": name} for claim, name in zip(left.claims, names, strict=True)]
    schema = claims_schema(names, view_names(len(left.views)), binary=rung == "arbitration")
    system, user = request.document["messages"]
    content = [*user["content"][:-1], {"type": "text", "text": claims_text(kept, broken)}]
    form = request.document["response_format"]
    document = {
        **request.document,
        "messages": [system, {**user, "content": content}],
        "response_format": {**form, "json_schema": {**form["json_schema"], "schema": schema}},
    }
    return Request(request.purpose, document, request.pictures, request.views, left.claims, again=True)


def _text(document: Document) -> Any:
    return document["messages"][1]["content"][-1]["text"]
