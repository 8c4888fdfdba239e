"""The pages of the server: of somebody who is asked, and of the organiser."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from http import HTTPStatus
from pathlib import Path
from typing import Any, Final
from urllib.parse import parse_qsl

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, RedirectResponse, Response
from starlette.routing import Route

from c4s.errors import BadInput
from c4s.human import QuestionDesk
from c4s.records.asking import ORGANISER
from reports.frame import environment
from reports.study.door import SEAT

STATIC: Final = Path(__file__).parent / "static"
MOST_BODY: Final = 16 << 10
"""Bytes of an answer."""
MOST_FIELDS: Final = 16
Handler = Callable[[Request], Awaitable[Response]]


class Seats:
    """Pages about a desk."""

    def __init__(self, desk: QuestionDesk, keys: dict[str, str]) -> None:
        self._desk, self._keys = desk, keys

    def app(self) -> Starlette:
        """The application; every path begins with a key, which the door has looked at."""
        routes = [
            Route("/{key}/", self.first),
            Route("/{key}/static/{name}", self.static),
            Route("/{key}/next", self.next),
            Route("/{key}/{number:int}", self.question, methods=["GET"]),
            Route("/{key}/{number:int}", self.answer, methods=["POST"]),
            Route("/{key}/{number:int}/{name}.png", self.picture),
        ]
        return Starlette(routes=routes, exception_handlers={HTTPException: _failed, OSError: _unkept})

    async def first(self, request: Request) -> Response:
        """What it is about and how far this one is; for the organiser how far everybody is."""
        seat = request.state[SEAT]
        if seat == ORGANISER:
            base = f"http://{request.headers['host']}"
            links = {name: f"{base}/{self._keys[name]}/" for name in self._desk.people}
            return self._page("organiser", desk=self._desk, links=links)
        return self._page("first", kind=self._desk.kind, done=self._desk.done(seat), of=self._desk.count(seat))

    async def next(self, request: Request) -> Response:
        """On to the first question without an answer, or to the first page where there is none."""
        seat = self._asked(request)
        done = self._desk.done(seat)
        return _to(str(done + 1) if done < self._desk.count(seat) else "./")

    async def question(self, request: Request) -> Response:
        """The page of a question; who comes too early or again is led on."""
        seat, number = self._place(request)
        if number != self._desk.done(seat) + 1:
            return _to("next")
        return self._shown(seat, number, "", {})

    async def answer(self, request: Request) -> Response:
        """Keep an answer, and on to the next question; a wrong one is shown again with what is wrong."""
        seat, number = self._place(request)
        fields = await _fields(request)
        try:
            self._desk.answer(seat, number, fields)
        except BadInput as error:
            if number != self._desk.done(seat) + 1:
                raise HTTPException(HTTPStatus.CONFLICT, error.what) from None
            return self._shown(seat, number, error.what, fields, HTTPStatus.UNPROCESSABLE_ENTITY)
        return _to("next")

    async def picture(self, request: Request) -> Response:
        """A picture of a question that is asked now or was answered."""
        seat, number = self._place(request)
        found = self._desk.picture(seat, number, request.path_params["name"])
        if found is None or number > self._desk.done(seat) + 1:
            raise HTTPException(HTTPStatus.NOT_FOUND, "there is no such picture")
        return Response(found, media_type="image/png")

    async def static(self, request: Request) -> Response:
        """A style or a script."""
        known = {path.name: path for path in STATIC.iterdir()}
        if request.path_params["name"] not in known:
            raise HTTPException(HTTPStatus.NOT_FOUND, "there is no such file")
        return FileResponse(known[request.path_params["name"]])

    def _shown(
        self, seat: str, number: int, wrong: str, given: dict[str, str], status: int = HTTPStatus.OK
    ) -> Response:
        asked = self._desk.question(seat, number)
        values = {"number": number, "of": self._desk.count(seat), "wrong": wrong, "given": given, **asked}
        return self._page(self._desk.kind, status, **values)

    def _asked(self, request: Request) -> str:
        seat: str = request.state[SEAT]
        if seat == ORGANISER:
            raise HTTPException(HTTPStatus.NOT_FOUND, "the organiser is asked nothing")
        return seat

    def _place(self, request: Request) -> tuple[str, int]:
        seat, number = self._asked(request), int(request.path_params["number"])
        if not 0 < number <= self._desk.count(seat):
            raise HTTPException(HTTPStatus.NOT_FOUND, "there is no such question")
        return seat, number

    def _page(self, template: str, status: int = HTTPStatus.OK, **values: Any) -> Response:
        return HTMLResponse(environment().get_template(f"study/{template}.html.j2").render(**values), status)


async def _fields(request: Request) -> dict[str, str]:
    """The fields of a form, each once."""
    body = b""
    async for part in request.stream():
        body += part
        if len(body) > MOST_BODY:
            raise HTTPException(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, "this answer is too long")
    try:
        pairs = parse_qsl(body.decode(), keep_blank_values=True, max_num_fields=MOST_FIELDS, errors="strict")
    except ValueError:
        raise HTTPException(HTTPStatus.BAD_REQUEST, "this is no form") from None
    if len(dict(pairs)) != len(pairs):
        raise HTTPException(HTTPStatus.BAD_REQUEST, "a field of this form is there twice")
    return dict(pairs)


def _to(where: str) -> Response:
    return RedirectResponse(where, HTTPStatus.SEE_OTHER)


async def _failed(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    template = environment().get_template("study/failed.html.j2")
    return HTMLResponse(template.render(message=error.detail), error.status_code, error.headers)


async def _unkept(request: Request, error: Exception) -> Response:
    """The disk did not take an answer: it is not in the file, and the browser tries again."""
    template = environment().get_template("study/failed.html.j2")
    message = f"This could not be kept: {error}. Nothing is lost but this answer; tell the organiser."
    return HTMLResponse(template.render(message=message), HTTPStatus.SERVICE_UNAVAILABLE)
