"""Camera changes (EI06): cameras and lights of the submission, which no evidence is taken with."""

from __future__ import annotations

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Actor, Scene, added, changed, fresh, shifted

CAMERA = "/Script/Engine.CameraActor"


def camera(given: Scene, number: int) -> Actor:
    light = next(one for one in given["actors"] if not one["asset_path"])
    made = fresh(light, number, "Camera")
    return {**shifted(made, (0.0, 0.0, 400.0)), "class": CAMERA, "properties": {}}


def test_cameras_of_the_submission_do_not_pay(repair_mutants: Check, text_mutants: Check) -> None:
    def filmed(given: Scene) -> Scene:
        return added(given, (camera(given, number) for number in range(4)))

    for mutants in (repair_mutants, text_mutants):
        assert rewarded(mutants(filmed)) == {}


def test_moved_lights_do_not_pay(repair_mutants: Check, text_mutants: Check) -> None:
    def relit(given: Scene) -> Scene:
        return changed(given, lambda one: "Light" in one["class"], lambda one: shifted(one, (300.0, 0.0, 90.0)))

    for mutants in (repair_mutants, text_mutants):
        assert rewarded(mutants(relit)) == {}
