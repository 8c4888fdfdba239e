"""Who is let in: a request for this machine, from one of this server's own pages, with a key that somebody was given.

The key is in the path, so nothing is sent along that another site's page could make a browser send. A name that
resolves to this machine is refused by its ``Host``; a form of another site by its ``Origin``.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Final

from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from c4s import loopback

SEAT: Final = "seat"
"""In a request's state: who sits there."""
HEADERS: Final = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
    "connect-src 'self'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-store",
}
"""Of every answer. A referrer would hold a key; to pages of this server it may."""


class FrontDoor:
    """An application behind such a door; every path in it begins with a key."""

    def __init__(self, app: ASGIApp, keys: Mapping[str, str]) -> None:
        """``keys``: by who they belong to."""
        self._app = app
        self._seats = {_digest(key): name for name, key in keys.items()}
        self._headers = [(name.lower().encode(), value.encode()) for name, value in HEADERS.items()]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse a request or hand it on."""
        if scope["type"] != "http":
            return

        async def sending(message: Message) -> None:
            if message["type"] == "http.response.start":
                message["headers"] = [*message["headers"], *self._headers]
            await send(message)

        status, why = self._refused(scope)
        if status:
            await PlainTextResponse(f"{why}\n", status, {"Connection": "close"})(scope, receive, sending)
        else:
            await self._app(scope, receive, sending)

    def _refused(self, scope: Scope) -> tuple[int, str]:
        strange = loopback.foreign(scope) or _from_elsewhere(scope)
        if strange:
            return 403, strange
        seat = self._seats.get(_digest(scope["path"].removeprefix("/").partition("/")[0]))
        if seat is None:
            return 404, "this link leads nowhere: ask who sent it for another"
        if not loopback.let_in(scope, seat):
            return 429, "too many connections with this link"
        scope["state"][SEAT] = seat
        return 0, ""


def _from_elsewhere(scope: Scope) -> str | None:
    """Why a request that changes something was not made by a page of this very server; else None."""
    headers = dict(scope["headers"])
    if scope["method"] in ("GET", "HEAD"):
        return None
    if headers.get(b"origin") != b"http://" + headers[b"host"]:
        return "answers are taken from this server's own pages"
    return None


def _digest(key: str) -> bytes:
    """The time of a look-up tells nothing of a key."""
    return hashlib.sha256(key.encode(errors="replace")).digest()
