"""The texts, to be read and checked: ``python -m cases.open190.texts [scene ...] [--prompts] [--truth]``.

A row a text: words, requirements, how many of each family, difficulty. ``--prompts`` prints them as agents read them,
``--truth`` exports each place and tells what the rule judge says of it by state alone (minutes).
"""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from pathlib import Path

from c4s.protocol.graph.check import sound_requirements
from c4s.protocol.rules import FAMILY_WEIGHTS
from c4s.records.evidence import catalog_facts
from c4s.records.pack import MANIFEST, Pack
from c4s.semantics.binding import bind
from c4s.semantics.state import StateDecider
from cases.model import TextCase
from cases.open190.layout import StagedPlace
from cases.open190.library import SCENES
from cases.open190.prompts import text_case
from cases.requirements import FAMILIES, bundle
from cases.standing import snapshot_of
from catalog.build import build_pack


def row(case: TextCase) -> list[str]:
    """A text in numbers."""
    predicates = case.requirements.predicates
    by_family = Counter(FAMILIES[one.type] for one in predicates)
    counts = [str(by_family[family]) for family in FAMILY_WEIGHTS]
    return [case.scene_id, str(len(case.description.split())), str(len(predicates)), *counts, case.difficulty]


def truth(case: TextCase, place: StagedPlace) -> Counter[str]:
    """How many requirements the rule judge says hold, do not hold, and are open on the place, by its state."""
    with tempfile.TemporaryDirectory(prefix="c4s-text-") as name:
        packs = Path(name)
        build_pack(place.assortment.pack(place.pack_id, case.title), packs, replace=True, previews=False)
        facts = catalog_facts([Pack.read(packs / place.pack_id / MANIFEST)])
        snapshot = snapshot_of(place.level(), [packs / place.pack_id])
    found = sound_requirements(bundle(case.case_id, case.description, case.description, case.requirements))
    decider = StateDecider(found, snapshot, facts, bind(found, facts, case.reviewed))
    return Counter(decider.decide(node).status for node in found.predicates)


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description="Read and check the texts of open-190.")
    parser.add_argument("scenes", nargs="*", help="all when none is named")
    parser.add_argument("--prompts", action="store_true", help="print the prompts")
    parser.add_argument("--truth", action="store_true", help="judge each place by state")
    options = parser.parse_args()
    print(
        "\t".join(["scene", "words", "requirements", *FAMILY_WEIGHTS, "difficulty", "holds", "open", "does not hold"])
    )
    for name in options.scenes or [name for name, spec in SCENES.items() if spec.kind == "text"]:
        place = SCENES[name].place()
        case = text_case(SCENES[name], place)
        said = truth(case, place) if options.truth else Counter()
        told = [str(said[status]) for status in ("MATCH", "UNKNOWN", "MISMATCH")] if options.truth else ["-"] * 3
        print("\t".join([*row(case), *told]), flush=True)
        if options.prompts:
            print(f"\n{case.description}\n", flush=True)


if __name__ == "__main__":
    main()
