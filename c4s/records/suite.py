"""The case package and the suite, as they lie on disk.

::

    <suite>/suite.json                       Suite: the frozen list of cases, with its own digest
    <suite>/digests.json                     SHA-256 of every file of both trees, to tell which one was changed
    <suite>/agent/<alias>/case.json          AgentCase: all that an agent may see ...
    <suite>/agent/<alias>/start.level.json   ... the level it starts from (image-to-scene: the corrupted copy)
    <suite>/agent/<alias>/references/*.png   ... reference views (image-to-scene)
    <suite>/withheld/<case>/case.json        WithheldCase
    <suite>/withheld/<case>/truth.level.json       the original scene; for text-to-scene the scene that the oracle saves
    <suite>/withheld/<case>/input.snapshot.json    exported from start.level.json (image-to-scene)
    <suite>/withheld/<case>/truth.snapshot.json    exported from truth.level.json
    <suite>/withheld/<case>/views/{start,truth}/*.png   what the reports show beside a submission
    <suite>/withheld/<case>/binding.json, bindings.reviewed.json   which assets the prompt's entities are (Binding)
    <suite>/withheld/<case>/recipe.json, cameras.json, requirements.bundle.json   in the published formats
    <suite>/withheld/<case>/target-cameras.json    held-out cameras on what was changed (image-to-scene)

``agent/`` and ``withheld/`` are two trees that are never under one mount. An agent meets a case under its alias, which
tells nothing; the readable id and title are for people, in the withheld tree and in what is made of a run. Packs are
named by id and digest and lie under ``c4s.home.packs_root()``.
"""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar, Final, Literal

from pydantic import Field

from c4s.errors import BadInput, unknown
from c4s.files import write_json
from c4s.names import InnerPath, Name, PackagePath
from c4s.protocol.settings import Setting
from c4s.records.base import Record, Sealed
from c4s.trees import listing_digest, read_listing

SUITE, DIGESTS = "suite.json", "digests.json"
"""The frozen list of cases, and the note of every file."""
SIGHTINGS, FROZEN = "sightings.json", "frozen.json"
"""Beside them: how well each change of each repair can be seen, and what a suite was frozen on."""
SELECTION = "selection.json"
"""Beside them in a suite that is made with its halves: which cases are public, and the nested sets."""
SUITE_FILE = "suite.yaml"
"""What an author writes of a suite (``cases.workshop``)."""
IMPORTED_SCENE = "scene.level.json"
"""A scene that no cases were made of yet lies in the folder of its suite."""


MOST_CALLS, MOST_MINUTES = 1_000_000, 1_000_000


class Budget(Record):
    """Limits of one attempt."""

    tool_calls: int = Field(gt=0, le=MOST_CALLS)
    wall_minutes: float = Field(gt=0, le=MOST_MINUTES)


class PackRef(Record):
    """A pack that a case needs."""

    pack_id: Name
    digest: str
    """SHA-256 of the pack manifest's canonical JSON (which holds the digests of its files)."""


class AgentCase(Record):
    """What an agent may see of a case."""

    schema_version: Literal["c4s.case.v2"] = "c4s.case.v2"
    alias: Name
    """What the case is called where an agent can see it."""
    setting: Setting
    prompt: str
    start_map: PackagePath
    """Package path of the start level, ``/Game/...``."""
    budget: Budget
    packs: list[PackRef]
    catalog: list[str]
    """Paths of the assets that the case offers (its catalog)."""
    plate_m: float | None = None
    """Side of the square build plate in metres (text-to-scene)."""
    reference_views: list[InnerPath] = Field(default_factory=list)
    """Files relative to the case's agent folder."""


Visibility = Literal["public", "private"]
"""Which panel a case belongs to: of private cases nothing is published but sums over all of them."""


class WithheldCase(Record):
    """What only the evaluator sees of a case."""

    schema_version: Literal["c4s.withheld.v2"] = "c4s.withheld.v2"
    case_id: Name
    alias: Name
    title: str = ""
    scene_id: Name
    """Source scene: the bootstrap cluster."""
    minimum_actors: int = 1
    """Integrity: the submission must hold at least this many actors."""
    operations: list[str] = Field(default_factory=list)
    """Corruption kinds in order (image-to-scene)."""
    operation_group: Literal["Restore", "Lifecycle", "Layout", "Symmetry", "Transform"] | None = None
    difficulty: Literal["easy", "medium", "hard"] | None = None
    proxy_assets: bool = False
    """The catalog's assets stand in for content that is not here."""
    visibility: Visibility = "public"
    author: Name | None = None
    """Who made the case: nobody reviews their own."""


class SuiteCase(Record):
    """One line of a suite."""

    case_id: Name
    alias: Name
    setting: Setting
    agent_digest: str
    withheld_digest: str


class Suite(Sealed):
    """A frozen list of cases."""

    REMEDY: ClassVar[str] = "restore the file, or build the suite again with --replace"
    schema_version: Literal["c4s.suite.v2"] = "c4s.suite.v2"
    suite_id: Name
    title: str
    description: str = ""
    packs: list[PackRef]
    cases: list[SuiteCase]


TARGET_CAMERAS: Final = "c4s.target-cameras.v1"
"""Schema of the record of a repair's held-out cameras: ``views`` as engines take them."""


class WithheldFolder:
    """What only the evaluator reads of a case: ``<suite>/withheld/<case>``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def truth_level(self) -> Path:
        """The original scene; for text-to-scene the scene that the oracle saves."""
        return self.root / "truth.level.json"

    @property
    def input_snapshot(self) -> Path:
        """Exported from the start level."""
        return self.root / "input.snapshot.json"

    @property
    def truth_snapshot(self) -> Path:
        """Exported from the truth."""
        return self.root / "truth.snapshot.json"

    @property
    def cameras(self) -> Path:
        """The cameras of a repair's reference pictures."""
        return self.root / "cameras.json"

    @property
    def target_cameras(self) -> Path:
        """The held-out cameras of a repair: its agent saw nothing from there."""
        return self.root / "target-cameras.json"

    @property
    def requirements(self) -> Path:
        """The requirement bundle."""
        return self.root / "requirements.bundle.json"

    @property
    def binding(self) -> Path:
        """Which assets the entities of the requirement bundle are bound to."""
        return self.root / "binding.json"

    @property
    def reviewed(self) -> Path:
        """What the case's author says of the binding; where there is nothing to say, there is no file."""
        return self.root / "bindings.reviewed.json"

    def views(self, role: str) -> Path:
        """Folder of the pictures of the ``start`` or the ``truth`` that reports show."""
        return self.root / "views" / role


class SuiteFolder:
    """A built suite on disk."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def record(self) -> Path:
        """The frozen list of cases."""
        return self.root / SUITE

    def suite(self) -> Suite:
        """The suite record; ``BadInput`` when there is none."""
        if not (self.root / SUITE).is_file():
            raise BadInput("no such suite", where=str(self.root), todo="build it with `c4s suite build`")
        return Suite.read(self.root / SUITE)

    @property
    def sightings(self) -> Path:
        """How well each change of each repair can be seen: rows by case id."""
        return self.root / SIGHTINGS

    @property
    def frozen(self) -> Path:
        """What the suite was frozen on (``Frozen``); there is none before that."""
        return self.root / FROZEN

    def case(self, case_id: str) -> SuiteCase:
        """The line of a case; ``BadInput`` when the suite has none of this id."""
        cases = {case.case_id: case for case in self.suite().cases}
        if case_id not in cases:
            raise unknown("case", case_id, cases, where=str(self.root))
        return cases[case_id]

    def agent(self, alias: str) -> Path:
        """Folder that an agent may read."""
        return self.root / "agent" / alias

    def withheld(self, case_id: str) -> Path:
        """Folder that only the evaluator reads."""
        return self.root / "withheld" / case_id

    def agent_case(self, alias: str) -> AgentCase:
        """The agent's side of a case."""
        return AgentCase.read(self.agent(alias) / "case.json")

    def withheld_case(self, case_id: str) -> WithheldCase:
        """The evaluator's side of a case."""
        return WithheldCase.read(self.withheld(case_id) / "case.json")

    def freeze(self, suite_id: str, title: str, description: str, packs: list[PackRef]) -> Suite:
        """Digest both trees of every case and write ``suite.json``."""
        cases: list[SuiteCase] = []
        files: dict[str, str] = {}
        for path in sorted((self.root / "withheld").iterdir()):
            alias = self.withheld_case(path.name).alias
            agent, withheld = read_listing(self.agent(alias)), read_listing(path)
            files |= {f"agent/{alias}/{name}": value for name, value in agent.items()}
            files |= {f"withheld/{path.name}/{name}": value for name, value in withheld.items()}
            cases.append(
                SuiteCase(
                    case_id=path.name,
                    alias=alias,
                    setting=self.agent_case(alias).setting,
                    agent_digest=listing_digest(agent),
                    withheld_digest=listing_digest(withheld),
                )
            )
        write_json(self.root / DIGESTS, dict(sorted(files.items())))
        suite = Suite(suite_id=suite_id, title=title, description=description, packs=packs, cases=cases)
        suite.write(self.root / SUITE)
        return suite
