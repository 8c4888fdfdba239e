"""What must hold for any repair: order, names and ids change nothing; the truth repairs itself; a stray is one FP.

The scenes hold no two actors of one content at one place: between such copies the protocol chooses by the order of the
export (the rows ``ties/`` of the published answers), so there order may count.
"""

from __future__ import annotations

import random
from copy import deepcopy

from hypothesis import assume, given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.verify.repair import repair_verdict
from c4s.verify.repair.batch import repair_row
from tests.verify_repair.repair_scenes import Scene, actor, scene, with_actor

KINDS = ["Chair", "Box", "Lamp"]
SPOTS = [(100.0 * x, 100.0 * y, 0.0) for x in range(-3, 4) for y in range(-3, 4)]
PLACES = st.permutations(SPOTS)
FATES = ["keep", "keep", "keep", "shift", "move", "turn", "grow", "mesh", "drop", "repaint"]


def changed(record: Scene, fate: str) -> list[Scene]:
    """What becomes of an actor."""
    record = deepcopy(record)
    pose, bounds = record["transform"], record["bounds"]
    if fate in ("shift", "move"):
        for vector in (pose["location_cm"], bounds["origin_cm"]):
            vector[0] += 0.05 if fate == "shift" else 47.0
    elif fate == "turn":
        pose["rotation_deg"][1] += 30.0
    elif fate == "grow":
        pose["scale"], bounds["extent_cm"] = [1.5] * 3, [15.0] * 3
    elif fate == "mesh":
        record["asset_path"] = record["component_asset_paths"][0] = "/Game/Room/SM_Wrong.SM_Wrong"
    elif fate == "repaint":
        record["material_paths"] = ["/Game/Room/M_Other.M_Other"]
    return [] if fate == "drop" else [record]


@st.composite
def cases(draw: st.DrawFn) -> tuple[Scene, Scene, Scene]:
    """Input, truth and candidate: two differently damaged forms of one scene, with actors of their own."""
    places, own = iter(draw(PLACES)), draw(st.lists(st.sampled_from(KINDS), min_size=4, max_size=4))
    truth = scene(
        *(
            actor(f"a{n}", draw(st.sampled_from(KINDS)), next(places), draw(st.sampled_from([0.0, 90.0])))
            for n in range(draw(st.integers(1, 7)))
        )
    )

    def damaged(extra: str) -> Scene:
        kept = [each for record in truth["actors"] for each in changed(record, draw(st.sampled_from(FATES)))]
        return scene(*kept, *(actor(f"{extra}{n}", own[n], next(places)) for n in range(draw(st.integers(0, 2)))))

    return damaged("in"), truth, damaged("out")


def counts(start: Scene, truth: Scene, candidate: Scene) -> tuple[int, int, int] | None:
    """TP, FP and FN as the batch command answers them; None for a refusal."""
    answer = repair_row({"name": "case", "input": start, "ground_truth": truth, "candidate": candidate})
    return None if "error" in answer else (answer["tp"], answer["fp"], answer["fn"])


def disguised(given: Scene, names: dict[str, str], rng: random.Random) -> Scene:
    """The scene in another order and under other names: one new name for each old one."""
    result = deepcopy(given)
    for record in result["actors"]:
        new = names.setdefault(record["stable_actor_id"], rng.choice("abcXYZ") + str(len(names)))
        record |= {
            "stable_actor_id": new,
            "label": f"Renamed {new}",
            "name": f"N_{new}",
            "actor_guid": new[::-1],
            "actor_path": f"/Game/S.S:PersistentLevel.{new}",
        }
    rng.shuffle(result["actors"])
    return result


def kinds(records: list[Scene]) -> set[str]:
    """Structural kinds of these small scenes: the mesh tells them apart."""
    return {record["asset_path"] for record in records}


@settings(max_examples=80, deadline=None)
@given(cases(), st.randoms(use_true_random=False))
def test_order_names_and_ids_change_nothing(case: tuple[Scene, Scene, Scene], rng: random.Random) -> None:
    start, truth, candidate = case
    names: dict[str, str] = {}
    again = (disguised(start, names, rng), disguised(truth, names, rng), disguised(candidate, {}, rng))
    assert counts(*case) == counts(*again)


@settings(max_examples=80, deadline=None)
@given(cases())
def test_every_target_is_one_tp_or_fn(case: tuple[Scene, Scene, Scene]) -> None:
    found = counts(*case)
    assume(found is not None)
    assert found is not None
    rows = repair_verdict(*case).measurements
    outcomes = [row["outcome"] for row in rows["targets"]]
    assert (outcomes.count("TP"), outcomes.count("FN")) == (found[0], found[2])
    assert len({row["identity"] for row in rows["targets"]}) == len(outcomes) == found[0] + found[2]


@settings(max_examples=80, deadline=None)
@given(cases())
def test_the_truth_scores_one_unless_a_removal_shares_its_kind(case: tuple[Scene, Scene, Scene]) -> None:
    start, truth, _ = case
    try:
        verdict = repair_verdict(start, truth, truth)
    except BadInput:
        assume(False)
        return
    keep = {record["stable_actor_id"] for record in truth["actors"]}
    removed = kinds([record for record in start["actors"] if record["stable_actor_id"] not in keep])
    wanted = {
        row["identity"].removeprefix("stable:"): row
        for row in verdict.measurements["targets"]
        if row["operation"] != "remove"
    }
    shared = [
        record for record in truth["actors"] if record["stable_actor_id"] in wanted and record["asset_path"] in removed
    ]
    told = [note for note in verdict.advisories if note["code"] == "removal-shares-a-descriptor"]
    if not shared:
        assert (verdict.score, told) == (1.0, [])
    else:
        assert sorted(told[0]["actors"]) == sorted(record["label"] for record in shared)


@settings(max_examples=80, deadline=None)
@given(cases(), st.sampled_from([*KINDS, "Unheard"]))
def test_a_stray_actor_beside_the_truth_is_exactly_one_false_positive(
    case: tuple[Scene, Scene, Scene], kind: str
) -> None:
    start, truth, _ = case
    before, stray = counts(start, truth, truth), actor("stray", kind, (9999.0, 9999.0, 0.0))
    assume(before is not None)
    assert before is not None
    keep = {record["stable_actor_id"] for record in truth["actors"]}
    to_remove = kinds([record for record in start["actors"] if record["stable_actor_id"] not in keep])
    if stray["asset_path"] not in to_remove:
        assert counts(start, truth, with_actor(truth, stray)) == (before[0], before[1] + 1, before[2])
    else:
        after = counts(start, truth, with_actor(truth, stray))
        assert after is not None and after[1] == before[1] + 1


@settings(max_examples=60, deadline=None)
@given(cases())
def test_a_stray_actor_of_no_known_kind_is_one_false_positive_beside_any_candidate(
    case: tuple[Scene, Scene, Scene],
) -> None:
    start, truth, candidate = case
    before = counts(*case)
    assume(before is not None)
    assert before is not None
    stray = actor("stray", "Unheard", (9999.0, 9999.0, 0.0)) | {"class": "/Script/Engine.SkeletalMeshActor"}
    assert counts(start, truth, with_actor(candidate, stray)) == (before[0], before[1] + 1, before[2])
