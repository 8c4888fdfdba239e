"""Whether what a spatial claim speaks of is there, by other claims (paper, "Conditional Spatial Composition analysis").

A separate check of an entity is another scored claim that says only that the entity exists: affirmative, of no other
entity, and without quality, amount or relation. It counts by its own answer, before any cap by parents. That a
collection is there says neither how many it has nor which.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from c4s.protocol.bundle import Predicate, Requirements
from c4s.protocol.rules import COMPOSITE_TYPES, FAMILY_OF_TYPE
from c4s.records.judgement import ClaimJudgement

_EXISTENCE: Final = ("existence", "presence")
_SPATIAL: Final = "spatial_composition"


class ExistenceChecks:
    """The separate existence checks of a bundle's entities, as a judge answered them."""

    def __init__(self, requirements: Requirements, said: Mapping[str, ClaimJudgement]) -> None:
        self._predicates = requirements.predicates
        self._of: dict[str, dict[str, str]] = {}
        for node in requirements.scored:
            entity = _checked(requirements.predicates[node])
            if entity is not None:
                self._of.setdefault(entity, {})[node] = said[node].answer

    def of(self, node: str) -> dict[str, Any] | None:
        """What the checks say of the entities of a spatial claim; None for any other claim.

        ``entities`` has the answers of each entity's checks by claim; ``pass`` is true where every entity has one and
        all of them are ``MATCH``. A claim of no entity does not pass: nothing shows what it speaks of.
        """
        predicate = self._predicates[node]
        if predicate.type in COMPOSITE_TYPES or FAMILY_OF_TYPE.get(predicate.type) != _SPATIAL:
            return None
        entities = {entity: self._of.get(entity, {}) for _, entity in predicate.arguments}
        held = [bool(checks) and set(checks.values()) == {"MATCH"} for checks in entities.values()]
        return {"entities": entities, "pass": bool(held) and all(held)}


def _checked(predicate: Predicate) -> str | None:
    """The entity whose existence a claim says and nothing more; None for any other claim."""
    more = predicate.negative or predicate.qualifiers or predicate.quantity or predicate.relation
    if predicate.type not in _EXISTENCE or more or len(predicate.arguments) != 1:
        return None
    return predicate.arguments[0][1]
