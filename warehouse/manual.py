"""``docs/warehouse.md``: what the warehouse holds, from the record models and the questions.

python -m warehouse.manual
"""

from __future__ import annotations

import inspect
import itertools
import re
import sys
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from c4s.files import write_text
from c4s.records.base import Record
from c4s.verify.registry import VERIFIERS
from warehouse.parquet import PARTITIONS, arrow_schema
from warehouse.records import TABLES, TrialKey
from warehouse.tables import FOUNDATIONS, KEPT, question_text, questions

PAGE: Final = Path(__file__).parents[1] / "docs" / "warehouse.md"
EXAMPLES: Final = {
    "outcomes": "SELECT configuration, avg(score) AS mean FROM outcomes GROUP BY ALL ORDER BY mean DESC",
    "attempts": "SELECT ended_by, count(*) AS attempts, avg(wall_s) AS mean_s FROM attempts GROUP BY ALL",
    "tool_use": "SELECT tool, sum(calls) AS calls FROM tool_use WHERE recorded GROUP BY tool ORDER BY calls DESC",
    "python_submissions": "SELECT parseable, count(*) AS scripts FROM python_submissions GROUP BY parseable",
    "calls": "SELECT tool, outcome, count(*) AS calls, sum(duration_s) AS seconds FROM calls GROUP BY ALL",
    "claims": "SELECT stage, answer, count(*) AS claims FROM claims WHERE scored GROUP BY ALL",
    "verdicts": "SELECT verifier, status, count(*) AS verdicts FROM verdicts GROUP BY ALL",
    "components": "SELECT verifier, name, avg(value) AS mean FROM components GROUP BY ALL ORDER BY ALL",
    "findings": "SELECT verifier, outcome, count(*) AS findings FROM findings GROUP BY ALL",
    "pictures": "SELECT role, count(*) AS pictures, sum(octet_length(jpeg)) AS bytes FROM pictures GROUP BY role",
    "scenes": "SELECT role, count(*) AS scenes, sum(octet_length(document)) AS bytes FROM scenes GROUP BY role",
    "shapes": "SELECT kind, count(*) AS shapes, sum(octet_length(data)) AS bytes FROM shapes GROUP BY kind",
    "schedule": "SELECT visibility, setting, count(DISTINCT case_id) AS cases FROM schedule GROUP BY ALL",
}
KEYS: Final = {
    "attempts": "`trial_id`, `attempt`",
    "tool_use": "`trial_id`, `attempt`, `tool`",
    "python_submissions": "`trial_id`, `attempt`, `call`",
    "calls": "`trial_id`, `attempt`, `call`",
    "claims": "`trial_id`, `claim`",
    "verdicts": "`trial_id`, `verifier`",
    "components": "`trial_id`, `verifier`, `name`",
    "findings": "none: an actor may have several",
    "pictures": "`trial_id`, `role`, `view`; pictures of a case have an empty `trial_id`",
    "scenes": "`trial_id`, `case_id`, `role`; scenes of a case have an empty `trial_id`",
    "shapes": "`suite`, `shape_sha256`",
}
"""Where it is not ``trial_id``."""
_UNITS: Final = (
    (re.compile(r"_s$"), "seconds"),
    (re.compile(r"_usd$"), "US dollars"),
    (re.compile(r"_tokens$"), "tokens"),
    (re.compile(r"_sha256$|_digest$"), "SHA-256, hexadecimal"),
    (re.compile(r"^(?:width|height)$"), "pixels"),
    (re.compile(r"calls$"), "calls"),
    (re.compile(r"_characters$"), "characters"),
    (re.compile(r"_at$"), "time, UTC"),
)
_HEAD: Final = """\
# The warehouse

Made by `python -m warehouse.manual` from the record models (`warehouse/records.py`) and the questions
(`warehouse/sql`).

Every trial writes its rows as Parquet, one file a table, below
`C4S_HOME/warehouse/<table>/suite=<suite>/configuration=<name>/`. These files are the truth. `c4s.duckdb` beside them
holds the same rows but those of `pictures`, `calls`, `scenes` and `shapes`, and can be deleted at any time.

```
c4s sql leaderboard                     # a question by its name
c4s sql "SELECT * FROM outcomes"        # or SQL (DuckDB's), which only reads
c4s sql leaderboard --out board.xlsx    # .csv, .parquet or .xlsx
c4s sql --allow data "SELECT * FROM 'data/mine.csv'"   # a folder of yours beside it
c4s sql --shell                         # one question after another: .tables, .schema, .export
c4s report --download rows              # every table as one sorted file, with a manifest of digests
```

A question reads the warehouse and no other file, loads no extension and opens no connection; `--allow FOLDER` opens a
folder of yours to it, for reading.

`warehouse.frames.frame(root, sql)` gives a pandas data frame; [analysis.ipynb](analysis.ipynb) shows it. Scores and
shares lie in [0, 1]. A null was not measured. Public and private cases (`visibility`) are panels of their own: their
scores are never one mean, and what leaves by pages and downloads tells of private cases only means over all of them.
"""


def manual() -> str:
    """The text of the page."""
    parts = [
        _HEAD,
        "## Tables\n",
        "Every table but `schedule` and `shapes` begins with the columns of a trial's key:\n",
    ]
    parts.append(_columns("outcomes", list(TrialKey.model_fields)))
    for name, model in TABLES.items():
        own = [
            field
            for field in model.model_fields
            if not issubclass(model, TrialKey) or field not in TrialKey.model_fields
        ]
        parts += [
            f"### {name}\n",
            f"{_marked(told_table(name))}\n",
            f"Key: {KEYS.get(name, '`trial_id`')}. Partitioned by {' and '.join(f'`{one}`' for one in PARTITIONS)}.\n",
            _columns(name, own),
            f"```sql\n{EXAMPLES[name]}\n```\n",
        ]
    parts += [
        "## Questions\n",
        "Each is a view, asked by its name; other SQL may build on it.\n",
        "| question | what it answers |",
        "|---|---|",
        *(f"| `{name}` | {_marked(told_question(name))} |" for name in questions()),
        "",
        f"Others build on {', '.join(f'`{name}`' for name in FOUNDATIONS)}; the answer of "
        f"{', '.join(f'`{name}`' for name in KEPT)} is kept and made anew when rows change. "
        "`settings` lists the settings.",
    ]
    return "\n".join(parts) + "\n"


@dataclass(frozen=True)
class ToldColumn:
    """A column as people are told of it."""

    name: str
    kind: str
    unit: str
    about: str


def told_columns(table: str) -> list[ToldColumn]:
    """All columns of a table."""
    schema, told = arrow_schema(table), _documented(TABLES[table])
    return [
        ToldColumn(
            name,
            f"{schema.field(name).type}{', or null' if schema.field(name).nullable else ''}",
            next((unit for pattern, unit in _UNITS if pattern.search(name)), ""),
            told.get(name, ""),
        )
        for name in schema.names
    ]


def told_table(table: str) -> str:
    """What a table holds, in a sentence."""
    about = re.sub(r"^Table ``\w+``: ", "", inspect.cleandoc(TABLES[table].__doc__ or ""))
    return about[:1].upper() + about[1:]


def told_question(name: str) -> str:
    """What a question answers: the comment that its SQL begins with."""
    lines = itertools.takewhile(lambda line: line.startswith("--"), question_text(name).splitlines())
    return " ".join(line.removeprefix("--").strip() for line in lines)


def _columns(table: str, names: list[str]) -> str:
    rows = ["| column | type | unit | what it is |", "|---|---|---|---|"]
    rows += [
        f"| `{one.name}` | {one.kind} | {one.unit} | {_marked(one.about)} |"
        for one in told_columns(table)
        if one.name in names
    ]
    return "\n".join(rows) + "\n"


def _documented(model: type[Record]) -> dict[str, str]:
    """What stands below each field in the source of a model and of its bases; headlines by their part."""
    found = {
        name: f"``{part}`` of the verifier ``{verifier.name}``; 0 where nothing was measured, null where this "
        "number is not known."
        for verifier in VERIFIERS.values()
        for name, part in verifier.headlines.items()
    }
    for made in reversed(model.__mro__):
        if issubclass(made, Record) and made is not Record and made.__module__.startswith("warehouse."):
            found |= dict(_fields_of(made))
    return found


def _fields_of(model: type[Record]) -> Iterator[tuple[str, str]]:
    try:
        source = textwrap.dedent(inspect.getsource(model))
    except (OSError, TypeError):
        return
    for name, text in re.findall(r'^    (\w+): [^\n]+\n    """(.*?)"""', source, re.MULTILINE | re.DOTALL):
        yield name, " ".join(text.split())


def _marked(text: str) -> str:
    return " ".join(text.replace("``", "`").split()).replace("|", "\\|")


if __name__ == "__main__":
    write_text(PAGE, manual())
    print(PAGE, file=sys.stderr)
