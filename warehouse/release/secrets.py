"""What private cases hold and nothing else: names, texts and pictures that may stand nowhere in what is published."""

from __future__ import annotations

import hashlib
import itertools
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path

from c4s.files import digest, read_json
from c4s.records.suite import SuiteFolder
from warehouse.database import ask, rows
from warehouse.release.words import beginnings_of, found_in, pieces, strings_of, words

SOURCES = ("warehouse", "reports", "c4s/verify", "c4s/protocol", "c4s/records")
"""Packages whose own words are no secret: field names, reasons, what pages say."""
LEAST_LETTERS = 4
"""Of a text that is no name of a case, trial or scene: shorter words stand everywhere."""
CORE = slice(1024, 1056)
"""Bytes of a picture that tell it inside of another file; those before are the same in many."""
NAMES = ("case", "alias", "scene", "trial")
"""Kinds that are names: without blanks, and looked for as they are, however short."""
OF_CONTENT = ("finding", "verdict", "file of the suite")
"""Kinds that what tools answer about public cases may say too: names of actors and assets."""
PRIVATE, PUBLIC = "private", "public"


@dataclass(frozen=True)
class Secrets:
    """What is looked for."""

    pieces: dict[str, str] = field(default_factory=dict)
    """Words, and what they are: ``case``, ``prompt``, ..."""
    pictures: frozenset[str] = frozenset()
    """SHA-256 of each picture's bytes."""
    cores: frozenset[bytes] = frozenset()
    """``CORE`` of each picture that is long enough."""
    joined: frozenset[str] = frozenset()
    """Pieces that are looked for as they are written: names, and what is one word with a number in it."""
    known: int = 0
    """Pieces that are not looked for, because public cases or c4s itself say the same."""

    @cached_property
    def beginnings(self) -> dict[str, tuple[int, ...]]:
        """How many words the pieces have, by their first."""
        return beginnings_of(self.pieces)

    def digest(self) -> str:
        """Digest of what is looked for."""
        cores = sorted(core.hex() for core in self.cores)
        return digest([self.pieces, sorted(self.joined), sorted(self.pictures), cores])

    def __bool__(self) -> bool:
        return bool(self.pieces or self.pictures)


def secrets_of(warehouse: Path, suites: Path | None = None, libraries: Sequence[str] = ()) -> Secrets:
    """The secrets of the private cases of a warehouse; none where it has no private case.

    A piece that public cases hold too, or that c4s itself says, is no secret: a source scene that both panels share, a
    common asset, a requirement of a usual kind. Actor labels and other texts of less than ``LEAST_LETTERS`` letters are
    not looked for.

    Args:
        warehouse: its rows: what was planned, found, said and drawn.
        suites: the folder of suites; where a suite with private cases lies there, its files are read too: aliases,
            requirements, assets and pictures that no row has.
        libraries: texts of others that pages carry: a word of theirs is no secret, be it an asset's name too.
    """
    if not rows(warehouse, f"SELECT 1 FROM schedule WHERE visibility = '{PRIVATE}' LIMIT 1"):
        return Secrets()
    wanted: dict[str, str] = {}
    apart: set[str] = set()
    pictures: set[str] = set()
    cores: set[bytes] = set()
    for kind, text in dict.fromkeys(_texts(warehouse, suites, PRIVATE)):
        found = [piece for piece in pieces(text) if _tells(kind, piece)]
        wanted.update((piece, kind) for piece in found if piece not in wanted)
        if kind not in NAMES and not (len(found) == 1 and _is_label(text)):
            apart.update(found)
    joined = frozenset(wanted.keys() - apart)
    for data in _pictures(warehouse, suites, PRIVATE):
        pictures.add(hashlib.sha256(data).hexdigest())
        if len(data) >= 2 * CORE.stop:
            cores.add(data[CORE])
    known: set[str] = set()
    others = {text for _, text in _texts(warehouse, suites, PUBLIC)}
    beginnings = beginnings_of(wanted)
    for text in itertools.chain([_own_words(), *libraries], _names_of_what_ran(warehouse), others):
        known |= found_in(text, wanted, beginnings, joined)
    for text in _answers(warehouse):
        known |= {piece for piece in found_in(text, wanted, beginnings) if wanted[piece] in OF_CONTENT}
    for data in _pictures(warehouse, suites, PUBLIC):
        pictures.discard(hashlib.sha256(data).hexdigest())
        cores.discard(data[CORE])
    kept = {piece: kind for piece, kind in wanted.items() if piece not in known}
    return Secrets(kept, frozenset(pictures), frozenset(cores), joined & kept.keys(), len(known))


def _is_label(text: str) -> bool:
    """Whether a text is one word with a number: apart, as in the cells of a table, both are another thing's."""
    return len(text.split()) == 1 and any(word.isdecimal() for word in words(text))


def _tells(kind: str, piece: str) -> bool:
    if not any(letter.isalpha() for letter in piece):
        return kind in NAMES and len(piece) >= LEAST_LETTERS
    return kind in NAMES or sum(letter.isalpha() for letter in piece) >= LEAST_LETTERS


def _texts(warehouse: Path, suites: Path | None, visibility: str) -> Iterator[tuple[str, str]]:
    """Every text of the cases of a panel with what it is."""
    planned = f"SELECT DISTINCT case_id, scene_id, title, prompt FROM schedule WHERE visibility = '{visibility}'"
    for row in rows(warehouse, planned):
        yield "case", row["case_id"]
        yield "scene", row["scene_id"]
        yield "title", row["title"]
        yield "prompt", row["prompt"]
    trials = f"SELECT trial_id FROM schedule WHERE visibility = '{visibility}'"
    for kind, columns, table in (
        ("trial", "trial_id", "schedule"),
        ("finding", "subject, detail", "findings"),
        ("message", "message", "attempts"),
        ("reason", "reason", "outcomes"),
    ):
        for texts in ask(warehouse, f"SELECT DISTINCT {columns} FROM {table} WHERE trial_id IN ({trials})")[1]:
            for text in texts:
                yield kind, text
    for row in rows(warehouse, f"SELECT document FROM verdicts WHERE trial_id IN ({trials})"):
        for text in strings_of(json.loads(row["document"])):
            yield "verdict", text
    for folder, kind, name in _folders(warehouse, suites, visibility):
        yield kind, name
        for path in sorted(folder.rglob("*.json")):
            for text in strings_of(read_json(path, what="file of a case")):
                yield "file of the suite", text


def _answers(warehouse: Path) -> Iterator[str]:
    """What agents sent and were answered in public cases."""
    found = "SELECT DISTINCT unnest([arguments, script, answer, error]) FROM calls"
    planned = f"SELECT trial_id FROM schedule WHERE visibility = '{PUBLIC}'"
    for (text,) in ask(warehouse, f"{found} WHERE trial_id IN ({planned})")[1]:
        yield text


def _pictures(warehouse: Path, suites: Path | None, visibility: str) -> Iterator[bytes]:
    cases = f"SELECT suite, suite_digest, case_id FROM schedule WHERE visibility = '{visibility}'"
    for (jpeg,) in ask(warehouse, f"SELECT jpeg FROM pictures WHERE (suite, suite_digest, case_id) IN ({cases})")[1]:
        yield bytes(jpeg)
    for folder, _, _ in _folders(warehouse, suites, visibility):
        for path in sorted(folder.rglob("*")):
            if path.suffix in (".png", ".jpg"):
                yield path.read_bytes()


def _folders(warehouse: Path, suites: Path | None, visibility: str) -> Iterator[tuple[Path, str, str]]:
    """Both folders of each case that lies among the suites, with what each is named by."""
    if suites is None:
        return
    found = rows(warehouse, f"SELECT DISTINCT suite, case_id FROM schedule WHERE visibility = '{visibility}'")
    for suite in sorted({row["suite"] for row in found}):
        folder = SuiteFolder(suites / suite)
        if not folder.record.is_file():
            continue
        wanted = {row["case_id"] for row in found if row["suite"] == suite}
        for case in folder.suite().cases:
            if case.case_id in wanted:
                yield folder.withheld(case.case_id), "case", case.case_id
                yield folder.agent(case.alias), "alias", case.alias


def _names_of_what_ran(warehouse: Path) -> Iterator[str]:
    """Names of suites, configurations, models, judges: not of cases, and published with every score."""
    columns = "suite, configuration, client, coalesce(model, ''), policy, judge, judge_version, engine"
    for row in ask(warehouse, f"SELECT DISTINCT {columns} FROM schedule")[1]:
        yield " | ".join(row)


@cache
def _own_words() -> str:
    root = Path(__file__).parents[2]
    files = [path for package in SOURCES for path in sorted((root / package).rglob("*")) if path.suffix in _OWN]
    return "\n".join(path.read_text(encoding="utf-8") for path in files)


_OWN = (".py", ".sql", ".j2", ".css", ".json", ".yaml")
