"""``c4s human serve`` and ``c4s human review``: people are asked in a browser on this machine until Ctrl-C."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from c4s.cli.output import print_json, say
from c4s.errors import BadInput
from c4s.home import human_root, reviews_root
from c4s.names import checked_name

if TYPE_CHECKING:
    from c4s.human import AnswerLog, QuestionDesk

LAST_PORT = 65_535
Port = Annotated[int, typer.Option(min=0, max=LAST_PORT, help="port (default: that of last time, at first any)")]
Json = Annotated[bool, typer.Option("--json", help="the links as a line of JSON")]


def serve(
    study: Annotated[str, typer.Argument(metavar="STUDY", help="name of the study")],
    port: Port = 0,
    json_output: Json = False,
) -> None:
    """Ask the annotators of a study in a browser: a link each, and one for who wants to see how far they are.

    It can be killed and begun again at any time; `c4s human intake STUDY` takes the answers in.
    """
    from c4s.human import RankingDesk, study_named

    opened = study_named(human_root(), study)
    _ask(
        opened.study.annotators,
        opened.folder.access,
        opened.folder.answers,
        lambda log, secret: RankingDesk(opened, log, secret),
        port,
        json_output,
    )


def review(
    suite: Annotated[str, typer.Argument(metavar="SUITE", help="id of a built suite")],
    reviewer: Annotated[list[str] | None, typer.Option(help="pseudonym of a reviewer; repeatable")] = None,
    port: Port = 0,
    json_output: Json = False,
) -> None:
    """Ask reviewers whether the cases of a suite are clear and can be solved from what an agent gets."""
    from c4s.cli.suites import built_suite
    from c4s.human import ReviewDesk
    from c4s.records.asking import ORGANISER, ReviewFolder
    from c4s.records.suite import SuiteFolder

    folder = SuiteFolder(built_suite(suite))
    people = list(dict.fromkeys(checked_name(name, "a reviewer") for name in reviewer or ["reviewer-1"]))
    if ORGANISER in people:
        raise BadInput(f"{ORGANISER!r} is who sees how far the others are", todo="give the reviewer another name")
    kept = ReviewFolder(reviews_root() / suite)
    _ask(
        people,
        kept.access,
        kept.reviews,
        lambda log, secret: ReviewDesk(folder, people, log, secret),
        port,
        json_output,
    )


def _ask(
    people: Sequence[str],
    access_file: Path,
    answers: Path,
    desk_of: Callable[[AnswerLog, str], QuestionDesk],
    port: int,
    json_output: bool,
) -> None:
    from c4s import loopback
    from c4s.human import AnswerLog, access_for, keep_access
    from reports.study import QuestionServer

    access = access_for(access_file, people, port)
    with AnswerLog(answers) as log:
        desk = desk_of(log, access.secret)
        listener = loopback.listener(access.port)
        keep_access(access_file, access)
        with listener, QuestionServer(desk, access, listener) as server:
            links = {name: server.link(name) for name in desk.people}
            if json_output:
                print_json({"organiser": server.link(), "people": links})
            else:
                say(f"{desk.title}: this server answers on this machine only; each link is somebody's own")
                say(f"organiser: {server.link()}")
                for name, link in links.items():
                    say(f"{name}: {link}")
                say("Ctrl-C ends it; begun again, it goes on where it was")
            with suppress(KeyboardInterrupt):
                server.wait()
        say(f"{len(log.rows)} answers in {answers}")
