"""Where this benchmark stands among others that score what agents make of 3D scenes.

Source: the paper's comparison (``tab:benchmark-positioning``, ``app:additional-related-work``), as it reports them; a
mark says that a component is reported there, not that it is as wide or as exact.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

COVERAGE: Final[dict[str, str]] = {
    "text": "Text asks",
    "images": "Pictures ask",
    "open": "Many right answers",
    "target": "A hidden target",
    "semantic": "Meaning",
    "physical": "Physics",
    "preservation": "What must stay",
}
"""What is compared, and its title."""


@dataclass(frozen=True)
class RelatedBenchmark:
    """One benchmark."""

    name: str
    artifact: str
    """What an agent hands in."""
    covers: frozenset[str]
    """Of ``COVERAGE``."""
    note: str


def _row(name: str, artifact: str, covers: str, note: str) -> RelatedBenchmark:
    return RelatedBenchmark(name, artifact, frozenset(covers.split()), note)


RELATED: Final[tuple[RelatedBenchmark, ...]] = (
    _row("BlenderGym", "script", "images target semantic", "edits of a Blender scene towards a goal picture"),
    _row(
        "SceneActBench",
        "GLB and poses",
        "images target semantic",
        "geometry, poses and motion against hidden targets; no score of physics of its own",
    ),
    _row(
        "4DBuildBench",
        ".blend file",
        "text open semantic physical",
        "dynamic scenes; mechanisms and spatial relations are audited beside the look",
    ),
    _row(
        "CutsceneBench",
        "sequence",
        "text open target semantic",
        "film sequences by cinematic judgement and reference sequences; collisions are a tool of agents, not a measure",
    ),
    _row(
        "WorldCoder-Bench", "HTML page", "text open semantic physical", "worlds as programs, by executable assertions"
    ),
    _row(
        "AuthorBench",
        "scene as JSON",
        "text open semantic physical preservation",
        "building and editing by language, on a description of a scene",
    ),
    _row(
        "VWE-Bench",
        "map of assets",
        "text open target semantic physical preservation",
        "changes of placed assets told in words; the present scene is given as pictures",
    ),
    _row(
        "Code4Scene",
        "Unreal level",
        "text images open target semantic physical preservation",
        "the saved level: built from a text, or repaired towards pictures and compared with a withheld truth",
    ),
)
