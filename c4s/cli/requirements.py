"""``c4s suite requirements``: check, bind and extract the requirement graphs of text cases."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from c4s.cli.output import check_new_file, print_json, print_table, say
from c4s.cli.progress import bars, step_line
from c4s.cli.suites import built_suite
from c4s.errors import BadInput
from c4s.files import read_json, read_plain_text, write_json
from c4s.home import packs_root
from c4s.names import checked_id
from c4s.protocol.graph.check import check_bundle
from c4s.protocol.graph.report import GraphReport
from c4s.protocol.settings import is_construction
from c4s.records.suite import SuiteFolder, WithheldFolder

app = typer.Typer(help="Requirement graphs of text cases: check, bind, extract.", no_args_is_help=True)
Source = Annotated[str, typer.Argument(help="id of a built suite, or a file")]
Case = Annotated[str | None, typer.Argument(help="id of a case of the suite")]
Json = Annotated[bool, typer.Option("--json")]
SHOWN = 4
"""Proposed assets of an entity that a table names."""


@app.command()
def check(source: Source, case: Case = None, json_output: Json = False) -> None:
    """Check requirement bundles by every rule (docs/requirements.md). Exit 2 where one cannot be used."""
    reports = {
        str(path): check_bundle(read_json(path, what="requirement bundle"), making=making)
        for path, making in _bundles(source, case)
    }
    if json_output:
        print_json({"bundles": [{"file": path, **report.plain()} for path, report in reports.items()]})
    else:
        for path, report in reports.items():
            _tell(path, report)
    for path, report in reports.items():
        report.refuse(where=path, todo="the report has every error; docs/requirements.md has the rules")


@app.command()
def bindings(
    suite: Annotated[str, typer.Argument(help="id of a built suite")],
    case: Annotated[str, typer.Argument(help="id of a text case of the suite")],
    json_output: Json = False,
) -> None:
    """Which assets of its catalog each entity of a case's prompt is, and which are only proposed."""
    from c4s.protocol.graph.check import sound_requirements
    from c4s.records.evidence import catalog_facts
    from c4s.records.pack import MANIFEST, Pack
    from c4s.semantics.binding import binding_of

    folder = SuiteFolder(built_suite(suite))
    withheld = _withheld(folder, case)
    opened = folder.agent_case(folder.case(case).alias)
    catalog = catalog_facts(Pack.read(packs_root() / pack.pack_id / MANIFEST) for pack in opened.packs)
    bundle = read_json(withheld.requirements, what="requirement bundle")
    requirements = sound_requirements(bundle, where=str(withheld.requirements))
    frozen = read_json(withheld.binding, what="binding") if withheld.binding.is_file() else None
    binding = binding_of(requirements, catalog, frozen, where=str(withheld.binding))
    if json_output:
        print_json({"suite": suite, "case": case, "frozen": frozen is not None, **binding.plain()})
        return

    def called(paths: list[str]) -> str:
        return ", ".join(str(catalog[path]["name"]) for path in paths)

    rows = []
    for identity, bound in binding.entities.items():
        shown = [f"{called([row.asset])} ({row.why})" for row in bound.proposed[:SHOWN]]
        more = [f"and {len(bound.proposed) - SHOWN} more"] if len(bound.proposed) > SHOWN else []
        rows.append([requirements.entities[identity].names[0], called(bound.assets) or "–", "; ".join(shown + more)])
    state = "frozen" if frozen is not None else "made now: this suite froze none"
    print_table(["entity", "is", "only proposed"], rows, title=f"Bindings of {case} ({state})")


@app.command()
def extract(
    source: Annotated[str, typer.Argument(help="file with a prompt, or id of a built suite")],
    case: Case = None,
    model: Annotated[str | None, typer.Option("--model", help="id of the model")] = None,
    endpoint: Annotated[
        str | None, typer.Option("--endpoint", help="name of a model endpoint (endpoints.yaml)")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="file to write the bundle to")] = None,
    repairs: Annotated[int, typer.Option(min=0, max=10, help="most answers after the first")] = 3,
    replace: Annotated[bool, typer.Option("--replace", help="replace the file where it is there")] = False,
    json_output: Json = False,
) -> None:
    """Let a model list the requirements of a prompt, and make a bundle of them. Exit 3 where no answer can be used."""
    if not model or not endpoint:
        raise BadInput(
            "requirements are extracted by a model, and none is named",
            todo="give --model and --endpoint, or write the requirements by hand (docs/requirements.md)",
        )
    if out is None:
        raise BadInput("there is no file to write the bundle to", todo="name one with --out")
    check_new_file(out)
    if out.exists() and not replace:
        raise BadInput("this file is there already", where=str(out), todo="name another, or add --replace")
    from cases.graphs.asking import asking, no_thinking
    from cases.graphs.extraction import extract as extracted_by

    case_id, prompt = _prompt(source, case)
    with bars() as progress, asking(endpoint, step_line) as ask:
        progress.add_task(f"extracting {case_id:40.40}", total=None)
        found = extracted_by(case_id, prompt, model, ask, repairs=repairs, fields=no_thinking(endpoint))
    write_json(out, found.bundle)
    if json_output:
        print_json({"file": str(out), "answers": found.answers, **found.report.plain()})
        return
    _tell(str(out), found.report)
    say(f"{found.answers} answer{'s' if found.answers > 1 else ''} of {model}")


def _tell(path: str, report: GraphReport) -> None:
    if report.findings:
        rows = [[finding.severity, finding.rule, finding.place, finding.message] for finding in report.findings]
        print_table(["", "rule", "where", "what"], rows, title=path)
    counts = ", ".join(f"{number} {what}" for what, number in report.counts.items())
    say(
        f"{path}: errors {len(report.errors)}, warnings {len(report.warnings)}"
        + (f"; {counts}; {report.coverage.covered} of {report.coverage.terms} content words covered" if counts else "")
    )


def _bundles(source: str, case: str | None) -> list[tuple[Path, bool]]:
    """The bundles that are meant, each with whether it is a file that can still be mended."""
    if case is None and (Path(source).is_file() or source.endswith(".json")):
        return [(Path(source), True)]
    folder = SuiteFolder(built_suite(source))
    if case is not None:
        return [(_withheld(folder, case).requirements, False)]
    cases = [row.case_id for row in folder.suite().cases if is_construction(row.setting)]
    found = [WithheldFolder(folder.withheld(name)).requirements for name in cases]
    there = [(path, False) for path in found if path.is_file()]
    if not there:
        raise BadInput("no case of this suite has a requirement bundle", where=source)
    return there


def _withheld(folder: SuiteFolder, case: str) -> WithheldFolder:
    withheld = WithheldFolder(folder.withheld(folder.case(case).case_id))
    if not withheld.requirements.is_file():
        raise BadInput("this case has no requirement bundle", where=case)
    return withheld


def _prompt(source: str, case: str | None) -> tuple[str, str]:
    """Case id and prompt, of a case of a suite or of a file, which is then called like the file."""
    if case is not None:
        folder = SuiteFolder(built_suite(source))
        return case, folder.agent_case(folder.case(case).alias).prompt
    path = Path(source)
    text: Any = read_plain_text(path, what="prompt")
    if not text.strip():
        raise BadInput("this prompt is empty", where=source)
    return checked_id(path.stem, "case"), text
