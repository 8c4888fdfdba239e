"""Which pictures a trial's submission is looked at through."""

from __future__ import annotations

from typing import Any

from c4s.evidence.held_out import truth_views
from c4s.evidence.shots import Cameras, Probe, Shots, Snapshot
from c4s.files import read_json
from c4s.protocol.bundle import read_requirements
from c4s.protocol.settings import is_construction
from c4s.records.evidence import catalog_facts
from c4s.records.pack import MANIFEST, Pack
from c4s.run.inputs import TrialInputs
from c4s.semantics.binding import binding_of
from c4s.semantics.sight import overview_plan, sight_plan
from c4s.semantics.sight.overviews import SIZE_PX


def cameras_for(given: TrialInputs) -> Cameras:
    """The plan of a case: of a construction the overview views and those that its claims need, of a repair its targets.

    A construction without a requirement bundle has no claims.
    """
    if not is_construction(given.case.setting):
        return _repair(given)
    withheld = given.withheld_folder
    if not withheld.requirements.is_file():
        return overview_plan
    requirements = read_requirements(read_json(withheld.requirements), where=str(withheld.requirements))
    catalog = catalog_facts([Pack.read(folder / MANIFEST) for folder in given.packs])
    frozen = read_json(withheld.binding) if withheld.binding.is_file() else None
    return sight_plan(requirements, catalog, binding_of(requirements, catalog, frozen, where=str(withheld.binding)))


def _repair(given: TrialInputs) -> Cameras:
    """The submission from the reference cameras; it and the original from held-out ones, where the case has them."""
    withheld = given.withheld_folder
    width, height = SIZE_PX
    size = {"width": width, "height": height}
    known = [{**view, **size, "purpose": "reference"} for view in read_json(withheld.cameras)["views"]]
    targets = read_json(withheld.target_cameras)["views"] if withheld.target_cameras.is_file() else []

    def plan(snapshot: Snapshot, _: Probe) -> Shots:
        cameras = [{**view, "purpose": "target", "pair": view["name"]} for view in targets]
        if not targets:
            return Shots(known)
        truth = truth_views(
            engine=snapshot["c4s"]["engine"],
            engine_version=snapshot["c4s"]["engine_version"],
            packs=given.packs,
            level=withheld.truth_level,
            cameras=[_of_truth(view) for view in targets],
        )
        return Shots([*known, *cameras], taken=truth)

    return plan


def _of_truth(view: dict[str, Any]) -> dict[str, Any]:
    return {**view, "name": f"truth-{view['name']}", "purpose": "truth", "pair": view["name"]}
