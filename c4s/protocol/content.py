"""What a scene of a case may be made of: one rule for the tools, for editor Python and for the integrity gate.

A scene may hold

* the assets of the case's catalog, those that its start level shows already, and the parts of Blueprints among them;
* what the engine has of its own: actor classes (lights, cameras, volumes, fog ...), basic shapes, ``/Engine`` content;
* the materials and textures of the case's packs: nothing is placed by them;
* what the run made of these and saved: copies of meshes, materials, material instances.

It may not hold another mesh or Blueprint, though a pack of the case has it: in the project of the case it is not there.
So it cannot be loaded, by a tool or by a script, and a scene that names it all the same has a package that does not
resolve (paper, "Candidate Integrity Checks": a frozen dependency policy; the same catalog for all agents). Whether
the engine has what is named under its own roots is the engine's affair: the published policy does not follow those.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Final

ENGINE_ROOTS: Final = ("/engine/", "/script/", "/temp/", "/paper2d/")
"""Package roots (lower case) that are the engine's own."""


def package_of(name: str) -> str:
    """The package of a path in any form: of an object, of a generated class, in export quotes."""
    text = name.strip()
    folder, slash, leaf = (text.split("'")[1] if text.count("'") >= 2 else text).rpartition("/")
    return folder + slash + leaf.partition(".")[0]


def is_the_engines(name: str) -> bool:
    """Whether a path lies under a root of the engine's own. Names are compared as the engine does, without case."""
    return name.casefold().startswith(ENGINE_ROOTS)


class Offered:
    """What a case offers of its packs' meshes and Blueprints, by their paths in any form."""

    def __init__(self, paths: Iterable[str]) -> None:
        self._packages = {package_of(path).casefold() for path in paths}

    def take_parts(self, parts: Mapping[str, Sequence[str]]) -> None:
        """Offer what the Blueprints that are offered are made of; ``parts`` by the path of each Blueprint."""
        waiting = [path for path in parts if path in self]
        while waiting:
            new = [part for part in parts.get(waiting.pop(), ()) if part not in self]
            self._packages |= {package_of(part).casefold() for part in new}
            waiting += new

    def __contains__(self, path: object) -> bool:
        name = package_of(str(path))
        return is_the_engines(name) or name.casefold() in self._packages
