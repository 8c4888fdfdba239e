"""What the files of a case's agent side give away: one check a kind of leak that the paper asks task packages to be
audited for (Evaluator Integrity; EI01).

An agent's folder holds ``case.json``, a start level and the reference pictures that the case names. Whatever else lies
there is a leak of the kind that it looks like.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Final

from c4s.editor.identity import ORIGIN_TAG
from c4s.errors import BadInput
from c4s.files import digest_file
from c4s.records.level import Level
from c4s.records.suite import AgentCase, SuiteFolder, WithheldCase
from c4s.trees import files_under

CASE, START = "case.json", "start.level.json"
EXTERNAL: Final = frozenset({"__externalactors__", "__externalobjects__"})
INSTANCES: Final = ("LevelInstance", "PackedLevel")
MAPS: Final = (".umap", ".level.json")
PREFABS: Final = (".uasset", ".uexp", ".ubulk", ".prefab", ".glb", ".gltf", ".fbx", ".obj", ".blend", ".dae", ".usd")
PICTURES: Final = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tga", ".exr", ".gif", ".tif", ".tiff", ".svg", ".mp4")
PNG_MAGIC: Final = b"\x89PNG\r\n\x1a\n"
PNG_TEXT: Final = frozenset({b"tEXt", b"zTXt", b"iTXt", b"eXIf", b"tIME"})


@dataclass(frozen=True)
class PackageLeak:
    """Something that an agent could read and must not."""

    case_id: str
    kind: str
    """Name of the check that found it."""
    file: str
    """Relative to the case's agent folder."""
    problem: str


@dataclass(frozen=True)
class Package:
    """The agent side of a case, and what of the evaluator's side it must not tell."""

    case: AgentCase
    withheld: WithheldCase
    root: Path
    files: list[str]
    start: Level | None
    truth: Level | None
    withheld_files: Mapping[str, str]
    """Names of withheld files by their digest."""

    def others(self) -> list[str]:
        """Files that the case does not name."""
        named = {CASE, START, *self.case.reference_views}
        return [name for name in self.files if name not in named]

    def others_like(self, *suffixes: str) -> list[str]:
        """Those of some kinds, by their names."""
        return [name for name in self.others() if name.lower().endswith(suffixes)]


Found = Iterator[tuple[str, str]]
"""Files and what is wrong with each."""


def original_maps(package: Package) -> Found:
    """The original level, or any other level than the start one."""
    for name in package.others_like(*MAPS):
        yield name, "another level than the start one"
    if package.start and package.truth and package.withheld.operations:
        if package.start.actors == package.truth.actors:
            yield START, "the start level is the original"
        if package.start.package == package.truth.package:
            yield START, f"the start level lies in the original's package {package.truth.package}"


def external_actors(package: Package) -> Found:
    """Actors that are stored beside a level, one a file."""
    for name in package.others():
        if EXTERNAL & {part.lower() for part in PurePosixPath(name).parts}:
            yield name, "an actor that is stored outside its level"


def level_instances(package: Package) -> Found:
    """Actors that stand for another level or for many packed actors."""
    for actor in package.start.actors if package.start else []:
        classes = [actor.class_path, *(part.class_path for part in actor.components)]
        if any(word in path for path in classes for word in INSTANCES):
            yield START, f"{actor.name} is of class {actor.class_path}"
        elif "world_asset" in actor.properties:
            yield START, f"{actor.name} names another level"


def prefabs(package: Package) -> Found:
    """Assets in the package, and Blueprints that the case does not offer."""
    for name in package.others_like(*PREFABS):
        yield name, "an asset that no pack holds"
    packs = {path.rpartition("/")[0].split("/")[2] for path in package.case.catalog if path.count("/") > 2}
    for path in sorted({actor.class_path for actor in package.start.actors} if package.start else []):
        if path.startswith("/Game/") and path.split("/")[2] not in packs:
            yield START, f"a Blueprint {path} of no pack of the case"


def cached_layouts(package: Package) -> Found:
    """Snapshots, recipes, caches and copies of withheld files."""
    known = {*package.others_like(*MAPS), *package.others_like(*PREFABS), *package.others_like(*PICTURES)}
    for name in package.others():
        if name not in known and not EXTERNAL & {part.lower() for part in PurePosixPath(name).parts}:
            yield name, "a file that the case does not name"
    for name in package.files:
        if name.endswith(".json") and (copy := package.withheld_files.get(digest_file(package.root / name))):
            yield name, f"the bytes of the withheld {copy}"


def screenshots(package: Package) -> Found:
    """Pictures that are no reference views, and reference views of the start scene."""
    for name in package.others_like(*PICTURES):
        yield name, "a picture that is no reference view"
    for name in package.case.reference_views:
        copy = package.withheld_files.get(digest_file(package.root / name), "")
        if copy and not copy.startswith("views/truth/"):
            yield name, f"the withheld picture {copy}"


def telling_metadata(package: Package) -> Found:
    """Words of the evaluator's side in names, documents and pictures; tags that only some actors have."""
    words = [package.withheld.case_id, package.withheld.author or "", "code4scenegt"]
    words += [package.withheld.title] if package.withheld.operations else []
    words = [word.lower() for word in words if len(word) > 3]
    for name in package.files:
        data = (package.root / name).read_bytes()
        text = f"{name}\n{data.decode('latin-1')}" if name.endswith(".json") else name
        for word in words:
            if word in text.lower():
                yield name, f"the words {word!r}"
        if data.startswith(PNG_MAGIC):
            for told in _texts(data):
                yield name, f"words inside the picture: {told[:60]!r}"
    if package.start and package.withheld.operations:
        origins = {tag for actor in package.start.actors for tag in actor.tags if tag.startswith(ORIGIN_TAG)}
        if len(origins) > 1:
            yield START, f"actors of several origins: {', '.join(sorted(origins))}"


CHECKS: Final[Mapping[str, Callable[[Package], Found]]] = {
    "original maps": original_maps,
    "externally stored actors": external_actors,
    "level instances and packed actors": level_instances,
    "prefabs": prefabs,
    "cached layouts": cached_layouts,
    "screenshots": screenshots,
    "telling metadata": telling_metadata,
}
"""By kind of leak, in the paper's order."""


def leaks(suite: SuiteFolder) -> list[PackageLeak]:
    """All leaks of a built suite, in the order of its cases and of the checks.

    ``BadInput`` for a link or a damaged file, which is refused before anything is looked for.
    """
    return [
        PackageLeak(line.case_id, kind, file, problem)
        for line in suite.suite().cases
        for package in [_package(suite, line.case_id, line.alias)]
        for kind, check in CHECKS.items()
        for file, problem in check(package)
    ]


def check_leaks(found: list[PackageLeak]) -> None:
    """``BadInput`` where there is one, with the first and their number."""
    if found:
        first = found[0]
        raise BadInput(
            f"{len(found)} leaks; the first: {first.problem} ({first.kind})",
            where=f"{first.case_id}: {first.file}",
            todo="build the suite again with --replace; nothing else may lie in its agent folders",
        )


def _package(suite: SuiteFolder, case_id: str, alias: str) -> Package:
    root, withheld = suite.agent(alias), suite.withheld(case_id)
    files = sorted(name for name, _ in files_under(root))
    truth = withheld / "truth.level.json"
    return Package(
        case=suite.agent_case(alias),
        withheld=suite.withheld_case(case_id),
        root=root,
        files=files,
        start=Level.read(root / START) if START in files else None,
        truth=Level.read(truth) if truth.is_file() else None,
        withheld_files={digest_file(withheld / name): name for name, _ in files_under(withheld)},
    )


def _texts(data: bytes) -> Iterator[str]:
    """What the chunks of a PNG file that hold words say, and what lies behind its end."""
    place = len(PNG_MAGIC)
    while place + 8 <= len(data):
        size, name = int.from_bytes(data[place : place + 4], "big"), data[place + 4 : place + 8]
        if name in PNG_TEXT:
            yield f"{name.decode()} {_plain(data[place + 8 : place + 8 + size])}"
        place += size + 12
        if name == b"IEND" and place < len(data):
            yield f"{len(data) - place} bytes behind the picture"
            return


def _plain(body: bytes) -> str:
    return body.decode("latin-1").replace("\0", " ")
