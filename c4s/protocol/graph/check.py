"""The one validator of requirement bundles, called when one is imported, frozen and loaded."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, TypeAlias

from c4s.protocol.bundle import Requirements, read_requirements
from c4s.protocol.graph.consistency import consistency_faults
from c4s.protocol.graph.coverage import coverage, coverage_faults
from c4s.protocol.graph.cycles import cycle_faults
from c4s.protocol.graph.grounding import grounding_faults
from c4s.protocol.graph.references import reference_faults
from c4s.protocol.graph.report import GraphFinding, GraphReport, gathered
from c4s.protocol.graph.scope import scope_faults
from c4s.protocol.graph.shape import shape_faults
from c4s.protocol.graph.view import BundleView

Rules: TypeAlias = Callable[[BundleView], Iterable[GraphFinding]]
RULES: tuple[Rules, ...] = (reference_faults, grounding_faults, scope_faults, cycle_faults, consistency_faults)


def check_bundle(bundle: Any, *, making: bool = False) -> GraphReport:
    """Check a bundle by every rule. Where fields are missing or of the wrong kind, that is all that is told.

    ``making``: whether it is being made now, so that a prompt's words that were left out can still be asked for.
    """
    faults = gathered(shape_faults(bundle))
    if faults:
        return GraphReport(faults)
    view = BundleView(bundle)
    covered = coverage(view)
    findings = [finding for rules in RULES for finding in rules(view)]
    counts = {
        "entities": len(view.entities),
        "predicates": len(view.predicates),
        "requirements": len(view.requirements),
    }
    return GraphReport(gathered([*findings, *coverage_faults(covered, making=making)]), covered, counts)


def sound_requirements(bundle: Any, *, where: str = "") -> Requirements:
    """Check a bundle and read it; ``BadInput`` in one line where it cannot be used."""
    check_bundle(bundle).refuse(where=where)
    return read_requirements(bundle, where=where)
