"""Text cases of the laid out places: the prompt of each, its requirements, and what its entities mean.

``text_case(SCENES[name], SCENES[name].place())`` is all that the suite needs.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any, Final

from c4s.errors import BadInput
from c4s.protocol.graph.check import sound_requirements
from c4s.records.binding import ReviewedBindings, ReviewedEntity
from c4s.semantics.binding import bind
from cases.model import Difficulty, TextCase
from cases.open190.layout import StagedPlace
from cases.open190.scenes import SceneSpec
from cases.open190.wording import Meant, Worded, worded
from cases.open190.words import WORDS
from cases.requirements import bundle
from cases.starter.stage import asset_path
from catalog.kits.maker import KitAsset
from catalog.shapes.spec import readable

CARPETS: Final = ("ground", "floor")
"""Families of tiles that the ground block of a prompt names."""
MOST_CARPETS: Final = 4
MINIMUM_ACTORS: Final = 20
RELATING: Final = ("spatial_relation", "distribution")
EASY_BELOW: Final = 70
MEDIUM_BELOW: Final = 86
"""Limits of a text's load, such that a third of the suite's texts is of each difficulty."""


def text_case(spec: SceneSpec, place: StagedPlace) -> TextCase:
    """The text case of a text scene that is laid out. ``BadInput`` where the prompt says what is not so."""
    if spec.scene_id not in WORDS:
        raise BadInput("this scene has no prompt", where=spec.scene_id)
    found = wording(spec.scene_id, place)
    return TextCase(
        case_id=f"text-{spec.scene_id}",
        scene_id=spec.scene_id,
        title=spec.title,
        description=found.text,
        requirements=found.requirements,
        plate_m=spec.plate_m,
        difficulty=difficulty(found),
        ground=carpets(place),
        minimum_actors=MINIMUM_ACTORS,
        reviewed=reviewed(found, place),
    )


def wording(scene_id: str, place: StagedPlace) -> Worded:
    """The prompt of a scene with the counts of a place put in, and its requirements."""
    return worded(WORDS[scene_id], lambda nouns: _meant(place, nouns))


def meant_things(place: StagedPlace, nouns: Sequence[str]) -> list[KitAsset]:
    """The things of the palette that nouns of the notation mean: ``House``, ``*Stall``, ``/boat`` (a family), each with
    ``:Red`` where only those are meant whose name says so."""
    return [thing for thing in place.assortment.things.values() if any(_means(noun, thing) for noun in nouns)]


def _means(noun: str, thing: KitAsset) -> bool:
    kind, _, told = noun.partition(":")
    if kind.startswith("/"):
        found = thing.family == kind[1:]
    elif kind.startswith("*"):
        found = thing.noun.endswith(kind[1:])
    else:
        found = thing.noun == kind
    return found and told in thing.name


def _meant(place: StagedPlace, nouns: Sequence[str]) -> Meant:
    things = meant_things(place, nouns)
    names = {thing.name for thing in things}
    return Meant(
        count=sum(item.thing.name in names for item in place.items.values()),
        names=tuple(readable(thing.noun).lower() for thing in things),
        ground=all(thing.flat for thing in things),
    )


def path_of(place: StagedPlace, thing: KitAsset) -> str:
    """Where a thing lies in the place's pack."""
    return asset_path(place.content_folder, thing.category, thing.name)


def catalog_of(place: StagedPlace) -> dict[str, dict[str, Any]]:
    """What the pack of a place will say of its things, by path, as far as they are bound by it."""
    return {
        asset_path(place.content_folder, spec.category, spec.name): {
            "name": readable(spec.name),
            "category": spec.category,
            "tags": list(spec.tags),
            "description": spec.description,
        }
        for spec in place.assortment.specs
    }


def reviewed(found: Worded, place: StagedPlace) -> ReviewedBindings:
    """What the author says of the bindings: which things each entity means where its words alone would bind others."""
    prompt = found.text
    made = bundle(place.scene_id, prompt, prompt, found.requirements)
    requirements = sound_requirements(made)
    bound = bind(requirements, catalog_of(place)).entities
    said: dict[str, ReviewedEntity] = {}
    for identity, entity in requirements.entities.items():
        key = entity.names[0]
        wanted = {path_of(place, thing) for thing in meant_things(place, found.things.get(key, ()))}
        chosen = set(bound[identity].assets)
        if chosen != wanted:
            said[identity] = ReviewedEntity(add=sorted(wanted - chosen), strike=sorted(chosen - wanted))
    return ReviewedBindings(entities=said)


def carpets(place: StagedPlace) -> list[str]:
    """Paths of the flat tiles that cover most of a place, the commonest first."""
    count = Counter(item.thing.name for item in place.items.values() if item.thing.family in CARPETS)
    return [path_of(place, place.thing(name)) for name, _ in count.most_common(MOST_CARPETS)]


def difficulty(found: Worded) -> Difficulty:
    """How hard a text is: by the number of its requirements, those that relate things counted twice."""
    load = len(found.predicates) + sum(one.type in RELATING for one in found.predicates)
    return "easy" if load < EASY_BELOW else "medium" if load < MEDIUM_BELOW else "hard"
