"""The plan of all pictures of a construction: four overview views, and the views that its claims need."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from c4s.evidence.shots import Camera, Probe, Shots, Snapshot
from c4s.protocol.bundle import Requirements
from c4s.records.binding import Binding
from c4s.records.captures import ClaimViews, ViewCoverage
from c4s.semantics.inventory import Array, Thing
from c4s.semantics.kinds import Facts
from c4s.semantics.sight.candidates import around, directions
from c4s.semantics.sight.clearance import Solids
from c4s.semantics.sight.looks import Choice, Sighting, choose, qualities
from c4s.semantics.sight.needs import DECIDED, ClaimNeed, Need, Needs
from c4s.semantics.sight.overviews import PROBE_PX as OVERVIEW_PROBE_PX
from c4s.semantics.sight.overviews import choose_overview, overview_cameras
from c4s.semantics.sight.scene import SightScene
from c4s.semantics.state import StateDecider

SIZE_PX = (640, 360)
"""Of a claim's picture."""
PROBE_PX = (128, 72)
MOST_VIEWS = 8
"""Claim views of a case, beside the four overview views."""
MOST_NEEDS = 60
"""Needs of a case that cameras are sought for; the rest, least urgent first, has what the others' views show."""
SHOWN = 0.9
"""No cameras are sought for a need that two overview views show at least this well."""
SEEN_SHARE = 2e-4
"""An actor is seen in a claim's view from this share of its pixels on (46 of 640 x 360)."""
_WAYS = directions(8, (14.0, 32.0, 58.0))
_EYES = 6
"""Cameras a need that are looked through."""
_OVERVIEW = "its objects are not in the catalog, or it speaks of the whole scene: the overview views show it"

Plan = Callable[[Snapshot, Probe], Shots]


def sight_plan(requirements: Requirements, catalog: Mapping[str, Facts], binding: Binding | None = None) -> Plan:
    """The plan of a construction with these requirements; it decides stage 1 on the scene that it is given."""

    def plan(snapshot: Snapshot, probe: Probe) -> Shots:
        return plan_sight(StateDecider(requirements, snapshot, catalog, binding), probe)

    return plan


def plan_sight(judge: StateDecider, probe: Probe) -> Shots:
    """Overview cameras, claim cameras, and which claim has which."""
    asking = Needs(judge)
    things = asking.things
    scene = SightScene.of(things, judge.grounding.landscapes)
    chosen = choose_overview(scene, things, probe)
    overview = overview_cameras([candidate.eye for candidate in chosen])
    asked = asking.all()
    needs, urgency = _distinct(asked)
    sizes = [OVERVIEW_PROBE_PX if not candidate.inner else PROBE_PX for candidate in chosen]
    looks = [
        Sighting(candidate.eye, width * height, candidate.glimpse, camera["name"])
        for candidate, camera, (width, height) in zip(chosen, overview, sizes, strict=True)
    ]
    quality = qualities(looks, needs, things)
    unshown = (quality < SHOWN).sum(axis=0) > len(looks) - 2
    sought = [needs[n] for n in np.flatnonzero(unshown).tolist() if urgency[n] < DECIDED][:MOST_NEEDS]
    looks += _looked(_eyes(things, scene, sought), probe)
    quality = qualities(looks, needs, things)
    centres = np.array([_points(things, need.things).mean(axis=0) for need in needs]).reshape(-1, 3)
    choice = choose(looks, quality, centres, urgency, MOST_VIEWS)
    names, cameras = _named(looks, choice)
    return Shots(
        [*overview, *cameras],
        {
            claim.claim: _views(claim, needs, choice, names, looks, things, [row["name"] for row in overview])
            for claim in asked
        },
    )


def _distinct(asked: Sequence[ClaimNeed]) -> tuple[list[Need], list[int]]:
    """The needs without repeats, most urgent first, with the urgency of each."""
    grade: dict[tuple[Any, ...], int] = {}
    need_of: dict[tuple[Any, ...], Need] = {}
    for claim in asked:
        for need in claim.needs:
            key = _key(need)
            need_of.setdefault(key, need)
            grade[key] = min(grade.get(key, claim.urgency), claim.urgency)
    order = sorted(need_of, key=lambda key: grade[key])
    return [need_of[key] for key in order], [grade[key] for key in order]


def _key(need: Need) -> tuple[Any, ...]:
    return need.kind, tuple(need.subjects), tuple(need.references)


def _points(things: Sequence[Thing], numbers: Sequence[int]) -> Array:
    """Corners (m, 3) of the boxes of some things."""
    return Solids(np.array([things[n].low for n in numbers]), np.array([things[n].high for n in numbers])).corners()


def _eyes(things: Sequence[Thing], scene: SightScene, needs: Sequence[Need]) -> list[Any]:
    eyes = []
    for need in needs:
        own = np.zeros(len(scene.boxes), dtype=bool)
        own[need.things] = True
        eyes += around(_framed(things, need), _WAYS, scene.boxes, own, scene.ground_cm, _EYES)
    return list(dict.fromkeys(eyes))


def _framed(things: Sequence[Thing], need: Need) -> Array:
    """What a need's picture holds: its subjects, and of a reference that is much larger the part around them."""
    subjects = _points(things, need.subjects)
    low, high = subjects.min(axis=0), subjects.max(axis=0)
    room = np.maximum(_BESIDE * float((high - low).max()), _BESIDE_CM)
    if not need.references:
        return subjects
    return np.concatenate([subjects, np.clip(_points(things, need.references), low - room, high + room)])


_BESIDE, _BESIDE_CM = 1.0, 150.0


def _looked(eyes: Sequence[Any], probe: Probe) -> list[Sighting]:
    seen = probe([eye.camera(f"probe-{number}", *PROBE_PX) for number, eye in enumerate(eyes)])
    pixels = PROBE_PX[0] * PROBE_PX[1]
    return [Sighting(eye, pixels, glimpse) for eye, glimpse in zip(eyes, seen, strict=True)]


def _named(looks: Sequence[Sighting], choice: Choice) -> tuple[dict[int, str], list[Camera]]:
    """Names of the views by the number of their camera, and the cameras that are to be taken for claims."""
    names = {number: look.name for number, look in enumerate(looks) if look.name}
    cameras: list[Camera] = []
    for place, number in enumerate(choice.taken, 1):
        names[number] = f"claim-{place:02}"
        cameras.append({**looks[number].eye.camera(names[number], *SIZE_PX), "purpose": "claim"})
    return names, cameras


def _views(
    claim: ClaimNeed,
    needs: Sequence[Need],
    choice: Choice,
    names: Mapping[int, str],
    looks: Sequence[Sighting],
    things: Sequence[Thing],
    overview: Sequence[str],
) -> ClaimViews:
    """The views of one claim with what they cover."""
    place = {_key(need): number for number, need in enumerate(needs)}
    own = [place[_key(need)] for need in claim.needs]
    primary = list(dict.fromkeys(found for n in own if (found := choice.primary[n]) is not None))
    other = (choice.alternate[n] for n in own)
    alternate = list(dict.fromkeys(found for found in other if found is not None and found not in primary))[:1]
    shown = [names[number] for number in primary]
    if claim.overview:
        shown = list(dict.fromkeys([*shown, *overview]))
    sought = list(dict.fromkeys(things[n].actor for need in claim.needs for n in need.things))
    reason = claim.reason
    if not shown:
        reason = reason or "every camera that was tried is cut off from its actors, or shows too little of them"
    return ClaimViews(
        primary=shown,
        alternate=[names[number] for number in alternate if names[number] not in shown],
        targets=sought,
        coverage=_coverage(claim, sought, [looks[number] for number in primary], things),
        reason="" if shown else reason,
    )


def _coverage(
    claim: ClaimNeed, sought: Sequence[str], looks: Sequence[Sighting], things: Sequence[Thing]
) -> ViewCoverage:
    seen = {actor: [look for look in looks if look.share(actor) >= SEEN_SHARE] for actor in sought}
    cropped = [actor for actor, by in seen.items() if by and all(actor in look.glimpse["edge"] for look in by)]
    share = max((sum(look.share(actor) for actor in sought) for look in looks), default=0.0)
    return ViewCoverage(
        targets=len({things[n].actor for n in claim.bound}),
        sought=len(sought),
        seen=sum(bool(by) for by in seen.values()),
        cropped=len(cropped),
        share_of_picture=round(min(share, 1.0), 4),
    )
