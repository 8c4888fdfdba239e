"""``c4s suite draft-prompt``: a first description of a scene, by a model that looks at pictures of it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import check_new_file, print_json, say
from c4s.cli.progress import bars, step_line
from c4s.errors import BadInput
from c4s.files import write_text


def draft_prompt(
    pictures: Annotated[list[Path], typer.Argument(help="PNG or JPEG pictures of one scene")],
    model: Annotated[str | None, typer.Option("--model", help="id of the model")] = None,
    endpoint: Annotated[
        str | None, typer.Option("--endpoint", help="name of a model endpoint (endpoints.yaml)")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="file to write the description to")] = None,
    about: Annotated[str, typer.Option("--about", help="what you call the place, told to the model")] = "",
    repairs: Annotated[int, typer.Option(min=0, max=10, help="most answers after the first")] = 3,
    replace: Annotated[bool, typer.Option("--replace", help="replace the file where it is there")] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Let a model describe what pictures of a scene show: a draft of a text case's prompt. Exit 3 where none is any
    good."""
    if not model or not endpoint:
        raise BadInput(
            "prompts are drafted by a model that looks, and none is named",
            todo="give --model and --endpoint, or write the prompt by hand (docs/requirements.md)",
        )
    if out is None:
        raise BadInput("there is no file to write the description to", todo="name one with --out")
    check_new_file(out)
    if out.exists() and not replace:
        raise BadInput("this file is there already", where=str(out), todo="name another, or add --replace")
    from cases.drafting import draft_description
    from cases.graphs.asking import asking, no_thinking

    with bars() as progress, asking(endpoint, step_line) as ask:
        progress.add_task(f"looking at {len(pictures)} pictures", total=None)
        found = draft_description(pictures, model, ask, about=about, repairs=repairs, fields=no_thinking(endpoint))
    write_text(out, found.text + "\n")
    words = len(found.text.split())
    if json_output:
        print_json({"file": str(out), "answers": found.answers, "faults": found.faults, "words": words})
        return
    say(f"{out}: {words} words, {found.answers} answer{'s' if found.answers > 1 else ''} of {model}")
    say(f"next: read it, then c4s suite requirements extract {out} --model {model} --endpoint {endpoint} --out FILE")
