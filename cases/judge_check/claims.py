"""The claims of a stage: three pairs of each of the eleven types, in words, as requirements, and with their truth.

Truth is read off the edit that was made, never off anything that judges.
"""

from __future__ import annotations

import random
import re
from collections.abc import Mapping
from typing import Any, Final, Literal

from c4s.protocol.graph.check import check_bundle
from cases.graphs.compiler import compile_bundle
from cases.graphs.ir import IRArgument, IREntity, IRLogic, IRQualifier, IRQuantity, IRRequirement, SemanticIR
from cases.judge_check.model import CheckScene, Claim, Sheet, Swap, Variant
from cases.judge_check.staging import COUNTS
from cases.requirements import REVIEW
from catalog.shapes.spec import readable

_NUMBERS: Final = {2: "two", 3: "three", 4: "four", 5: "five"}
_PLACE = "place"
_SEED = 7

Facts = dict[Variant, bool]


class _Author:
    """Collects the entities and claims of one stage."""

    def __init__(self, stage: CheckScene) -> None:
        self.stage = stage
        self.claims: list[Claim] = []
        self._entities: dict[str, tuple[str, str, bool]] = {}

    def name(self, asset: str, *, many: bool = False) -> str:
        """What an asset is called; asking makes it an entity."""
        plain = readable(asset).lower()
        one, several = self.stage.names.get(asset, (plain, _plural(plain)))
        known = self._entities.get(asset)
        self._entities[asset] = (one, several, many or (known is not None and known[2]))
        return several if many else one

    def entities(self, description: str) -> tuple[IREntity, ...]:
        """All entities, quoted where the description first names them."""
        made = [
            IREntity(
                key=_PLACE,
                name=_PLACE,
                source_text=_PLACE,
                entity_type="region",
                grounding_mode="scene_global",
                referent_kind="individual",
            )
        ]
        for asset, (one, several, many) in self._entities.items():
            quoted = several if re.search(rf"\b{several}\b", description) else one
            made.append(
                IREntity(
                    key=asset,
                    name=one,
                    source_text=quoted,
                    entity_type="object",
                    grounding_mode="actor_collection" if many else "actor",
                    referent_kind="collection" if many else "individual",
                )
            )
        return tuple(made)

    def row(self, kind: Any, text: str, *about: str, key: str = "", **more: Any) -> IRRequirement:
        """A requirement; ``about`` are the assets of its subject and references, the place where there is none."""
        arguments = [
            IRArgument(role="subject" if number == 0 else "reference", entity_key=asset)
            for number, asset in enumerate(about or (_PLACE,))
        ]
        name = key or f"{kind}{len(self.claims):02}"
        return IRRequirement(key=name, name=name, requirement_type=kind, source_text=text, arguments=arguments, **more)

    def flips(self, held: bool, kind: Any, text: str, *about: str, twin: Variant = "edited", **more: Any) -> None:
        """A claim that holds on the base and not on its twin, or the other way round."""
        row = self.row(kind, text, *about, **more)
        sides: tuple[Variant, Variant] = ("base", twin) if held else (twin, "base")
        self.claims.append(Claim(row, row.key, true_on=sides[0], false_on=sides[1]))

    def turned(self, kind: Any, true: str, false: str, **more: Mapping[str, Any]) -> None:
        """Two claims on the base: one holds, the other does not."""
        pair = f"{kind}{len(self.claims):02}"
        self.claims.append(Claim(self.row(kind, true, **more.get("true", {})), pair, true_on="base"))
        self.claims.append(Claim(self.row(kind, false, **more.get("false", {})), pair, false_on="base"))


def _plural(words: str) -> str:
    ending = "es" if re.search("(s|x|z|ch|sh)$", words) else "s"
    return f"{words[:-1]}ies" if re.search("[^aeiou]y$", words) else words + ending


def _a(words: str) -> str:
    return f"{'an' if words[0] in 'aeiou' else 'a'} {words}"


def _quality(kind: str, words: str) -> dict[str, Any]:
    return {"qualifiers": [IRQualifier(kind=kind, source_text=words)]}


def sheet(stage: CheckScene) -> tuple[str, Sheet]:
    """The description that holds all claims of a stage, a sentence each and well mixed, and the claims."""
    author = _Author(stage)
    for write in (_existence, _quantity, _attribute, _material, _relation, _distribution, _composition, _scene, _logic):
        write(author)
    random.Random(f"{_SEED}{stage.name}").shuffle(author.claims)
    description = " ".join(claim.row.source_text for claim in author.claims)
    return description, Sheet(author.entities(description), tuple(author.claims))


def bundle(stage: CheckScene) -> dict[str, Any]:
    """The claims of a stage as a requirement bundle in the published format. ``BadInput`` where it is not one."""
    description, made = sheet(stage)
    rows = [row for claim in made.claims for row in (claim.row, *(operand for operand, _ in claim.operands))]
    ir = SemanticIR(entities=list(made.entities), requirements=rows)
    found = compile_bundle(f"judge-check-{stage.name}", description, ir, {"authoring_parser": "authored"}, {**REVIEW})
    check_bundle(found, making=True).refuse(where=stage.name)
    return found


def _existence(author: _Author) -> None:
    cast = author.stage.cast
    for held, asset in ((True, cast.removed), (True, cast.replaced), (False, cast.newcomer)):
        author.flips(held, "presence", f"There is {_a(author.name(asset))}.", asset)


def _quantity(author: _Author) -> None:
    exact, least, most = author.stage.cast.counted
    modes: tuple[tuple[str, bool, Literal["exact", "at_least", "at_most"], int, str], ...] = (
        (exact, True, "exact", COUNTS[0][0], "exactly"),
        (least, False, "at_least", COUNTS[1][1] - 1, "at least"),
        (most, True, "at_most", COUNTS[2][0], "at most"),
    )
    for asset, held, mode, value, words in modes:
        text = f"There are {words} {_NUMBERS[value]} {author.name(asset, many=True)}."
        author.flips(held, "quantity", text, asset, quantity=IRQuantity(mode=mode, value=value))


def _attribute(author: _Author) -> None:
    cast, swap = author.stage.cast, author.stage.cast.recoloured
    for held, color in ((True, swap.was), (False, swap.becomes)):
        text = f"The {author.name(swap.asset)} is {color}."
        author.flips(held, "attribute", text, swap.asset, **_quality("color", color))
    text = f"The {author.name(cast.tipped)} lies on its side."
    author.flips(False, "attribute", text, cast.tipped, **_quality("orientation", "lies on its side"))


def _material(author: _Author) -> None:
    cast = author.stage.cast
    swaps: tuple[tuple[Swap, bool], ...] = ((cast.remade, True), (cast.remade, False), (cast.remade_too, True))
    for swap, held in swaps:
        material = swap.was if held else swap.becomes
        text = f"The {author.name(swap.asset)} is made of {material}."
        author.flips(held, "material", text, swap.asset, **_quality("material", material))


def _relation(author: _Author) -> None:
    cast = author.stage.cast
    mover, neighbour = author.name(cast.mover), author.name(cast.neighbour)
    for held, words, relation in ((True, "right next to", "next_to"), (False, "far away from", "far_from")):
        text = f"The {mover} is {words} the {neighbour}."
        author.flips(held, "spatial_relation", text, cast.mover, cast.neighbour, relation=relation)
    text = f"The {author.name(cast.carried)} is on top of the {author.name(cast.carrier)}."
    author.flips(True, "spatial_relation", text, cast.carried, cast.carrier, relation="on_top_of")


def _distribution(author: _Author) -> None:
    cast = author.stage.cast
    rowed, spaced = author.name(cast.rowed, many=True), author.name(cast.spaced, many=True)
    for held, words, asset, named in (
        (True, "in a straight row", cast.rowed, rowed),
        (False, "in a circle", cast.rowed, rowed),
        (True, "evenly spaced", cast.spaced, spaced),
    ):
        author.flips(held, "distribution", f"The {named} stand {words}.", asset, **_quality("layout", words))


def _composition(author: _Author) -> None:
    cast = author.stage.cast
    focal = author.name(cast.focal)
    fillers = author.name(cast.filler, many=True)
    for held, text, about in (
        (True, f"The {focal} is the focal point in the middle of the scene.", (cast.focal,)),
        (True, f"Open floor is kept clear all around the {focal}.", (cast.focal,)),
        (False, f"The {focal} is hemmed in on all sides by {fillers}.", (cast.focal, cast.filler)),
    ):
        author.flips(held, "composition", text, *about)


def _scene(author: _Author) -> None:
    stage = author.stage
    author.flips(True, "environment", "It is a bright day.", twin="restyled", **_quality("time", "bright day"))
    author.flips(False, "environment", "It is a dark night.", twin="restyled", **_quality("time", "dark night"))
    outdoors, indoors = "The place is outdoors under the open sky.", "The place is the inside of a building."
    told = (indoors, outdoors) if stage.indoors else (outdoors, indoors)
    author.turned("environment", *told)
    for true, false in stage.identities:
        author.turned("scene_identity", f"This is {true}.", f"This is {false}.")
    author.flips(
        True, "style_bundle", "The style is naturalistic with many different materials and colours.", twin="restyled"
    )
    author.flips(
        False,
        "style_bundle",
        "The style is that of a model in which every surface has the same bare material.",
        twin="restyled",
    )
    author.turned("style_bundle", *(f"The whole keeps to {style}." for style in stage.style))


def _logic(author: _Author) -> None:
    cast = author.stage.cast
    there: Facts = {"base": True, "edited": False}
    never: Facts = {"base": False, "edited": False}
    later: Facts = {"base": False, "edited": True}
    for held, operator, opening, joint, parts in (
        (True, "all_of", "The scene holds both", "and", ((cast.removed, there), (cast.replaced, there))),
        (False, "any_of", "Somewhere stands", "or", ((cast.newcomer, later), (cast.absent, never))),
        (True, "none_of", "One finds neither", "nor", ((cast.newcomer, later), (cast.absent, never))),
    ):
        words = [_a(author.name(asset)) for asset, _ in parts]
        text = f"{opening} {words[0]} {joint} {words[1]}."
        key = f"logic{len(author.claims):02}"
        operands = tuple(
            (author.row("presence", phrase, asset, key=f"{key}_{number}"), facts)
            for number, (phrase, (asset, facts)) in enumerate(zip(words, parts, strict=True))
        )
        row = IRRequirement(
            key=key,
            name=key,
            requirement_type="logic",
            source_text=text,
            logic=IRLogic(operator=operator, requirement_keys=[operand.key for operand, _ in operands]),
        )
        sides: tuple[Variant, Variant] = ("base", "edited") if held else ("edited", "base")
        author.claims.append(Claim(row, key, true_on=sides[0], false_on=sides[1], operands=operands))
