"""Freezing what the entities of a case are bound to."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from c4s.protocol.graph.check import sound_requirements
from c4s.records.binding import ReviewedBindings
from c4s.records.evidence import catalog_facts
from c4s.records.pack import Pack
from c4s.records.suite import WithheldFolder
from c4s.semantics.binding import bind

BUNDLE, REVIEWED = ".bundle.json", ".bindings.json"
"""How the names of a published bundle, and of the reviewed bindings beside it, end."""


def freeze_binding(
    withheld: WithheldFolder, bundle: Any, packs: Sequence[Pack], reviewed: ReviewedBindings | None = None
) -> None:
    """Bind the entities of a bundle to the assets of packs, and write the binding and what was reviewed of it."""
    bind(sound_requirements(bundle), catalog_facts(packs), reviewed).write(withheld.binding)
    if reviewed is not None:
        reviewed.write(withheld.reviewed)


def reviewed_beside(bundle: Path) -> ReviewedBindings | None:
    """The author's reviewed bindings beside a bundle: ``x.bindings.json`` of ``x.bundle.json``; None without one."""
    place = bundle.with_name(bundle.name.removesuffix(BUNDLE) + REVIEWED)
    return ReviewedBindings.read(place) if place.is_file() else None
