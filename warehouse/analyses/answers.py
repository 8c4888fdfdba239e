"""Answering a study from the warehouse, keeping the answer with its rows, and giving it again to the last digit."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from c4s.errors import BadInput, unknown
from c4s.files import digest, digest_bytes
from c4s.folders import beside, put_folder
from c4s.records.analysis import StudyResult, StudySource
from c4s.records.version import code_version
from warehouse.analyses.scope import StudyScope, WantedScope, choose
from warehouse.analyses.study import StudyDefinition, StudyOptions
from warehouse.database import arrow

RESULT = "analysis.json"


def answer(
    warehouse: Path, study: StudyDefinition, wanted: WantedScope, options: StudyOptions, place: Path
) -> StudyResult:
    """Ask, compute, and keep the answer with its rows in a folder of ``place``.

    Raises:
        BadInput: no such results, an option that the study does not take, or rows of which it can say nothing.
    """
    scope = choose(warehouse, wanted, study.across)
    tables = _asked(warehouse, study, scope)
    result = _computed(study, scope, options, tables, _sources(study, tables))
    _keep(result, tables, place)
    return result


def result_of(
    warehouse: Path, study: StudyDefinition, scope: StudyScope, options: StudyOptions | None = None
) -> StudyResult:
    """The same answer in a scope that is chosen already; nothing is kept."""
    return next(results_of(warehouse, study, scope, [options or StudyOptions()]))


def results_of(
    warehouse: Path, study: StudyDefinition, scope: StudyScope, options: Iterable[StudyOptions]
) -> Iterator[StudyResult]:
    """An answer for each of these options, from rows that are asked for once."""
    tables = _asked(warehouse, study, scope)
    sources = _sources(study, tables)
    for one in options:
        yield _computed(study, scope, one, tables, sources)


def _computed(
    study: StudyDefinition,
    scope: StudyScope,
    options: StudyOptions,
    tables: dict[str, pa.Table],
    sources: list[StudySource],
) -> StudyResult:
    options = heeded(study, options)
    return StudyResult(
        name=study.name,
        title=study.title,
        section=study.section,
        scope=scope.told(),
        options=options.plain(),
        sources=sources,
        findings=study.compute({name: table.to_pandas() for name, table in tables.items()}, options),
        made_by=computed_by(),
    )


def _sources(study: StudyDefinition, tables: dict[str, pa.Table]) -> list[StudySource]:
    return [_source(name, study.sources[name], table) for name, table in tables.items()]


def folder_of(result: StudyResult, place: Path) -> Path:
    """Where an answer is kept."""
    return place / f"{result.name}-{result.identity()}"


def replay(place: Path, identity: str, studies: dict[str, StudyDefinition]) -> tuple[StudyResult, StudyResult]:
    """A kept answer, and the same computed again from the rows that lie beside it.

    Args:
        place: folder of the answers.
        identity: the end of an answer's folder, or its start from 4 digits on.

    Raises:
        BadInput: there is no such answer, or its rows or record are not as they were written.
    """
    folder = _find(place, identity)
    kept = StudyResult.read(folder / RESULT)
    if kept.name not in studies:
        raise unknown("study", kept.name, studies, where=str(folder))
    study, frames = studies[kept.name], {}
    for source in kept.sources:
        path = folder / f"{source.name}.parquet"
        try:
            table = pq.read_table(path)
        except (OSError, pa.ArrowException) as error:
            raise BadInput(f"these rows cannot be read: {error}", where=str(path)) from None
        if _rows_digest(table) != source.rows_sha256:
            raise BadInput("these are not the rows of the answer", where=str(path), todo="run `c4s analyze` again")
        frames[source.name] = table.to_pandas()
    findings = study.compute(frames, StudyOptions.parse(kept.options))
    return kept, kept.model_copy(update={"findings": findings, "made_by": computed_by()})


def computed_by() -> str:
    """Digest of the code that computes: statistics, the rules of the benchmark, and studies."""
    here = Path(__file__).parent
    own = digest({path.name: digest_bytes(path.read_bytes()) for path in sorted(here.glob("*.py"))})
    return f"{code_version('stats', 'protocol')}-{own[:12]}"


def heeded(study: StudyDefinition, options: StudyOptions) -> StudyOptions:
    """What was given over the study's own defaults; ``BadInput`` for what it would not heed."""
    given = {name: getattr(options, name) for name in options.model_fields_set}
    for name in sorted(given.keys() - study.takes):
        raise BadInput(f"the study {study.name!r} takes no option {name!r}", todo=f"c4s analyze {study.name}")
    for name, values in given.items():
        if isinstance(values, list) and (twice := [one for one in values if values.count(one) > 1]):
            raise BadInput(f"{twice[0]!r} is named twice among {name!r}", todo="name each configuration once")
    return StudyOptions.parse({**study.defaults, **given})


def _asked(warehouse: Path, study: StudyDefinition, scope: StudyScope) -> dict[str, pa.Table]:
    return {name: arrow(warehouse, _within(scope.sql(), sql), where=name) for name, sql in study.sources.items()}


def _within(chosen: str, sql: str) -> str:
    return f"WITH chosen AS ({chosen}) SELECT * FROM ({sql})"


def _source(name: str, sql: str, table: pa.Table) -> StudySource:
    return StudySource(name=name, sql=sql, rows=len(table), rows_sha256=_rows_digest(table))


def _rows_digest(table: pa.Table) -> str:
    columns = [[_plain(value) for value in column.to_pylist()] for column in table.columns]
    return digest([table.column_names, columns])


def _plain(value: Any) -> Any:
    """A value that JSON has: what is not finite by its name."""
    return repr(value) if isinstance(value, float) and not math.isfinite(value) else value


def _keep(result: StudyResult, tables: dict[str, pa.Table], place: Path) -> None:
    folder = folder_of(result, place)
    if (folder / RESULT).is_file():
        return
    place.mkdir(parents=True, exist_ok=True)
    with beside(folder) as scratch:
        made = scratch / folder.name
        made.mkdir()
        for name, table in tables.items():
            pq.write_table(table, made / f"{name}.parquet", compression="zstd")
        result.write(made / RESULT)
        put_folder(made, folder, marker=RESULT)


def _find(place: Path, identity: str) -> Path:
    found = [path for path in sorted(place.glob("*")) if path.name.rpartition("-")[2].startswith(identity)]
    if len(found) != 1 or len(identity) < 4:
        known = [path.name.rpartition("-")[2] for path in sorted(place.glob("*"))]
        if len(found) > 1:
            raise BadInput(f"{len(found)} answers begin with {identity!r}", where=str(place), todo="give more digits")
        raise unknown("answer", identity, known, where=str(place))
    return found[0]
