"""``c4s suite select``: which cases stand for all, by what agents scored on them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from c4s.cli.output import print_json, print_table, say
from c4s.errors import BadInput
from c4s.files import MOST_WHOLE, write_text
from c4s.home import warehouse_root
from c4s.numbers import half_up

if TYPE_CHECKING:
    from cases.workshop.document import SelectionFile
    from warehouse.analyses.choosing import ChosenSet, NestedSets


def select_cases(
    suite: Annotated[str, typer.Argument(help="suite with results in the warehouse")],
    out: Annotated[
        Path | None, typer.Option(help="write the selection file here: `visibility: FILE` of a suite.yaml")
    ] = None,
    size: Annotated[
        list[str] | None,
        typer.Option(
            help="cases of a set: 95, or 20/25/50 of each setting; repeatable (default: 61, 75, 95, 128, or shares)"
        ),
    ] = None,
    public: Annotated[
        int | None, typer.Option(min=1, help="size of the set that becomes public (default: the second largest)")
    ] = None,
    withdraw: Annotated[
        list[str] | None, typer.Option(help="case that is in no set; another takes its place; repeatable")
    ] = None,
    pool: Annotated[
        list[str] | None, typer.Option(help="configuration by whose scores cases are chosen; repeatable (default: all)")
    ] = None,
    build: Annotated[str | None, typer.Option(help="start of the digest of its build (default: the latest)")] = None,
    policy: Annotated[str | None, typer.Option(help="score policy")] = None,
    judge: Annotated[str | None, typer.Option(help="judge")] = None,
    judge_version: Annotated[str | None, typer.Option(help="version of the judge")] = None,
    engine: Annotated[str | None, typer.Option(help="engine")] = None,
    seed: Annotated[int, typer.Option(min=0, max=MOST_WHOLE, help="seed of the rivals that draw")] = 23917,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Choose the cases whose plain means stand for those of all, in nested sets, and hold them against rivals.

    Errors are of configurations that the sets were chosen without. The answer names private cases: keep it.
    """
    from warehouse.analyses.choosing import counts_of, pools_of, select, trials_of
    from warehouse.analyses.scope import WantedScope
    from warehouse.database import catch_up

    if out is not None and out.exists():
        raise BadInput("there is something here already", where=str(out), todo="choose another --out")
    catch_up(warehouse_root())
    wanted = WantedScope(
        suite=suite, suite_digest=build, policy=policy, judge=judge, judge_version=judge_version, engine=engine
    )
    scope, trials = trials_of(warehouse_root(), wanted)
    pools = pools_of(trials, pool or [])
    sizes = counts_of(size or [], pools)
    kept = sizes[max(len(sizes) - 2, 0)] if public is None else next((one for one in sizes if sum(one) == public), None)
    if kept is None:
        raise BadInput(f"no set has {public} cases", todo=f"--size {public}")
    selection = select(scope, pools, sizes, kept, withdrawn=withdraw or [], seed=seed)
    chosen = selection.sets[sizes.index(kept)]
    file = _file(selection, chosen)
    if out is not None:
        write_text(out, _yaml(file))
    if json_output:
        errors = [vars(row) for row in selection.errors]
        worst = [one.worst for one in selection.sets]
        print_json(
            {
                **file.plain(),
                "public": len(chosen.cases),
                "worst": worst,
                "errors": errors,
                "written": None if out is None else str(out),
            }
        )
        return
    _show(selection, chosen)
    if out is None:
        say("next: --out FILE writes the selection; `visibility: FILE` in a suite.yaml takes it")
    else:
        say(f"{out}: {len(chosen.cases)} public cases. next: `visibility: {out.name}` in the suite.yaml beside it")


def _file(selection: NestedSets, chosen: ChosenSet) -> SelectionFile:
    from cases.workshop.document import SelectionFile, SelectionSet

    public = set(chosen.cases)
    return SelectionFile(
        suite_id=selection.suite,
        suite_digest=selection.suite_digest,
        pool={pool.setting: pool.agents for pool in selection.pools},
        sets=[SelectionSet(size=len(one.cases), cases=one.cases) for one in selection.sets],
        withdrawn=selection.withdrawn,
        visibility={
            case: "public" if case in public else "private"
            for pool in selection.pools
            for case in pool.cases
            if case not in selection.withdrawn
        },
    )


def _yaml(file: SelectionFile) -> str:
    import yaml

    return str(yaml.safe_dump(file.plain(), sort_keys=False, allow_unicode=True))


def _show(selection: NestedSets, chosen: ChosenSet) -> None:
    print_table(
        ["set", *(pool.setting for pool in selection.pools), "largest error", "public"],
        [
            [len(one.cases), *one.counts, half_up(one.worst, 3), "yes" if one is chosen else ""]
            for one in selection.sets
        ],
        title=f"Cases of {selection.suite} that stand for all (error in deviations of random sets of the size)",
    )
    print_table(
        ["set", "method", "error of totals", "error of parts", "reversed pairs"],
        [
            [
                row.cases,
                row.method,
                half_up(row.total_error, 4),
                half_up(row.part_error, 4),
                half_up(row.reversed_pairs, 1),
            ]
            for row in selection.errors
        ],
        title="Each configuration left out in turn",
    )
    for case, taken in selection.withdrawn.items():
        say(f"{case} is withdrawn; " + (f"{taken} takes its place" if taken else "its place needs nobody"))
