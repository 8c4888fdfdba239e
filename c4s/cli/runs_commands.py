"""``c4s runs``: the runs that are here; pausing, draining and going on with one; dropping what is no longer needed."""

from __future__ import annotations

import time
from collections import Counter
from datetime import datetime
from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.left_out import refuse_left_out
from c4s.cli.output import print_json, print_table, say
from c4s.cli.runs import run_folder
from c4s.errors import BadInput, MachineryFault, unknown
from c4s.folders import beside
from c4s.home import runs_root, suites_root
from c4s.records.folder import RunFolder
from c4s.records.guards import Word
from c4s.records.plan import Plan
from c4s.run.bounds import seconds_of
from c4s.run.droppable import MEANS, PARTS, Found, drop, droppable, size_of
from c4s.run.guards import ask
from c4s.run.lease import Held, RunHeld, at_work, take, told
from c4s.run.progress import Progress
from c4s.run.store import open_store

app = typer.Typer(no_args_is_help=True, help="The runs that are here: list, pause, drain, go on, prune.")
WHOLE = "run"
Run = Annotated[str, typer.Argument(help="id of a run, or its folder")]
Json = Annotated[bool, typer.Option("--json")]


@app.command("list")
def list_runs(json_output: Json = False) -> None:
    """The runs, how far each is, and what it takes on the disk. Exit 2 where one cannot be read."""
    rows, left_out = [], []
    for run in RunFolder.planned(runs_root()):
        try:
            now = Progress(run.root, suites_root() / Plan.read(run.plan).suite_id).read()
        except BadInput as error:
            left_out.append(error)
            continue
        rows.append(
            {
                "run": run.root.name,
                "suite": now.suite_id,
                "state": now.state,
                "done": now.done,
                "planned": now.planned,
                "spent_usd": now.spent_usd,
                "bytes": size_of(run.root),
                "last": datetime.fromtimestamp(_touched(run)).astimezone().isoformat(timespec="seconds"),
            }
        )
    if json_output:
        print_json(rows)
    else:
        columns = ["run", "suite", "state", "trials", "spent USD", "size", "last work"]
        print_table(
            columns,
            [
                [
                    row["run"],
                    row["suite"],
                    row["state"],
                    f"{row['done']}/{row['planned']}",
                    row["spent_usd"],
                    size_text(int(str(row["bytes"]))),
                    row["last"],
                ]
                for row in rows
            ],
        )
    refuse_left_out(left_out)


@app.command()
def pause(run: Run) -> None:
    """No stage of a run starts until `c4s runs go-on`; what is in work ends, and whoever holds the run keeps it."""
    _ask(run, "pause", "no stage starts; `c4s runs go-on` ends that")


@app.command()
def drain(run: Run) -> None:
    """No attempt of a run starts any more: what is in work ends and is scored, then the run ends with exit 1."""
    _ask(run, "drain", "no attempt starts; the same `c4s run` again goes on later")


@app.command("go-on")
def go_on(run: Run) -> None:
    """End a pause."""
    _ask(run, "go", "it goes on")


@app.command()
def prune(
    runs: Annotated[list[str] | None, typer.Argument(help="ids or folders of runs (default: look at all)")] = None,
    drop_parts: Annotated[
        list[str] | None, typer.Option("--drop", help=f"what to drop: {', '.join((*PARTS, WHOLE))}; repeatable")
    ] = None,
    older: Annotated[str | None, typer.Option(help="only runs without work for so long: 30d, 12h")] = None,
    keep: Annotated[int, typer.Option(min=0, max=1_000_000, help="leave the newest so many runs as they are")] = 0,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="say what would be dropped, and drop nothing")] = False,
    json_output: Json = False,
) -> None:
    """Say what of the runs can be dropped, in bytes; drop what --drop names of the runs that are named.

    Nothing is removed without both. A run that somebody works on is left out. Dropped parts change no score; a whole
    run (`--drop run`) is gone: its trials count as not done.
    """
    wanted = list(dict.fromkeys(drop_parts or ()))
    for part in wanted:
        if part not in (*PARTS, WHOLE):
            raise unknown("part", part, (*PARTS, WHOLE), where="--drop")
    age_s = None if older is None else seconds_of(older, "--older")
    if wanted and not runs and not dry_run:
        raise BadInput("no run is named: nothing is dropped", todo="name the runs, or give --dry-run")
    chosen = _chosen(runs or (), age_s, keep)
    dropping = bool(wanted) and not dry_run
    rows = [row for run in chosen for row in (_drop(run, wanted) if dropping else _look(run, wanted))]
    if json_output:
        print_json({"dropped": dropping, "rows": rows})
        return
    print_table(
        ["run", "part", "what", "files and folders", "size"],
        [[row["run"], row["part"], row["what"], row["count"], size_text(int(str(row["bytes"])))] for row in rows],
    )
    total = size_text(sum(int(str(row["bytes"])) for row in rows if wanted or row["part"] != WHOLE))
    say(f"{total} {'dropped' if dropping else 'can be dropped: name runs, and with --drop what to drop of them'}")


def size_text(size: int) -> str:
    """A size, for people."""
    return f"{size / (1 << 20):,.1f} MiB" if size >= 1 << 20 else f"{-(-size // (1 << 10))} KiB"


def _ask(run: str, word: Word, told: str) -> None:
    folder = RunFolder(run_folder(run))
    if Progress(folder.root).read().state == "done":
        raise BadInput("this run is done", where=run, todo="ask a run that is at work (`c4s runs list`)")
    ask(folder, word)
    say(f"{run}: {told}" if at_work(folder) else f"{run}: {told}; nobody works on it now, and a new start clears this")


def _touched(run: RunFolder) -> float:
    """When somebody last worked on a run: Unix time, seconds."""
    paths = [run.plan, *run.leases.glob("[0-9]*"), *run.journals.glob("*.jsonl")]
    return max(path.stat().st_mtime for path in paths)


def _chosen(named: list[str] | tuple[()], age_s: float | None, keep: int) -> list[RunFolder]:
    """The named runs, or all of them, without the newest ``keep`` and those of late."""
    every = sorted(RunFolder.planned(runs_root()), key=_touched, reverse=True)
    newest = {run.root.resolve() for run in every[:keep]}
    runs = [RunFolder(run_folder(name)) for name in named] or every
    return [
        run
        for run in runs
        if run.root.resolve() not in newest and (age_s is None or time.time() - _touched(run) > age_s)
    ]


def _look(run: RunFolder, wanted: list[str]) -> list[dict[str, object]]:
    """What could be dropped of a run: of the parts that are wanted, or of all."""
    busy = bool(at_work(run))
    found = [] if busy else list(droppable(run))
    rows = [row for row in _rows(run, found) if not wanted or row["part"] in wanted]
    if not busy and (not wanted or WHOLE in wanted):
        rows.append(_whole(run))
    return rows


def _drop(run: RunFolder, wanted: list[str]) -> list[dict[str, object]]:
    """Drop parts of a run, as its holder; what was dropped."""
    held = take(open_store().leases(run.leases), "run")
    if not isinstance(held, Held):
        raise BadInput(f"{told(held)} works on this run", where=str(run.root), todo="wait for it, or stop it")
    try:
        if who := at_work(run, holders=False):
            raise RunHeld(f"{who} works on this run", where=str(run.root), todo="wait until its work has ended")
        found = [one for one in droppable(run) if one.part in wanted]
        for one in found:
            drop(one, run)
        rows = _rows(run, found)
        if WHOLE in wanted:
            rows.append(_whole(run))
            _remove(run.root)
    finally:
        held.give_back()
    return rows


def _remove(run: Path) -> None:
    """Remove a run's folder, which is out of its place at once: whoever waits for the run begins in a new one."""
    if run.is_symlink():
        raise BadInput("a run is a folder, this is a link", where=str(run), todo="remove what it leads to")
    try:
        with beside(run) as scratch:
            run.rename(scratch / run.name)
    except OSError as error:
        todo = "see who writes there, and remove what is left by hand"
        raise MachineryFault(f"not all of this run could be removed: {error}", where=str(run), todo=todo) from error


def _whole(run: RunFolder) -> dict[str, object]:
    return {
        "run": run.root.name,
        "part": WHOLE,
        "what": "all of it; its trials are no longer done",
        "count": 1,
        "bytes": size_of(run.root),
    }


def _rows(run: RunFolder, found: list[Found]) -> list[dict[str, object]]:
    sizes: Counter[str] = Counter()
    counts: Counter[str] = Counter()
    for one in found:
        sizes[one.part] += one.size
        counts[one.part] += 1
    return [
        {"run": run.root.name, "part": part, "what": MEANS[part], "count": counts[part], "bytes": sizes[part]}
        for part in PARTS
        if counts[part]
    ]
