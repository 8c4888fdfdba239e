"""What the claims of a case are grounded in: its requirement bundle and its binding, checked when they are loaded."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from c4s.files import read_json
from c4s.protocol.graph.check import sound_requirements
from c4s.records.binding import Binding
from c4s.records.evidence import catalog_facts
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import WithheldFolder
from c4s.semantics.binding import check_binding


def check_grounds(withheld: WithheldFolder, packs: Sequence[Path]) -> None:
    """``BadInput`` for a bundle that cannot be used, or a binding that is of another bundle or of other packs.

    A case without a bundle has nothing to check; one without a frozen binding is bound when it is judged.
    """
    if not withheld.requirements.is_file():
        return
    bundle = read_json(withheld.requirements, what="requirement bundle")
    requirements = sound_requirements(bundle, where=str(withheld.requirements))
    if withheld.binding.is_file():
        catalog = catalog_facts(Pack.read(folder / MANIFEST) for folder in packs)
        check_binding(Binding.read(withheld.binding), requirements, catalog, where=str(withheld.binding))
