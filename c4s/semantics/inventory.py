"""The inventory of a scene: one thing an object that was placed, with the facts of its asset and its world box.

A thing is known by its asset (catalog name, category, tags, description) or, where the catalog does not know the asset,
by the last part of the asset's path. Actor labels are chosen by the agent under test and are never read; so are the
names of assets that it made itself: where there is a catalog, an asset that it does not hold has no name (an engine
shape has).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.geometry.transform import affine, transformed_box
from c4s.protocol.words import has_phrase, names_object, phrases_of

Array: TypeAlias = NDArray[np.float64]
Facts: TypeAlias = Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class Thing:
    """One placed object. ``low`` and ``high`` are its world box in cm."""

    actor: str
    asset: str
    facts: Facts | None
    """Catalog facts; None for an asset that the catalog does not hold."""
    low: Array
    high: Array
    scale: Array
    materials: tuple[str, ...]
    """Paths of the materials that the actor shows."""
    named: bool = True
    """Whether the name of an asset without facts can be trusted."""

    @property
    def centre(self) -> Array:
        """Centre of the box (cm)."""
        return (self.low + self.high) / 2

    @property
    def basic_shape(self) -> bool:
        """Whether it is an engine primitive, which could stand for anything."""
        return self.asset.lower().startswith("/engine/basicshapes/")

    def is_a(self, phrases: Iterable[tuple[str, ...]]) -> bool:
        """Whether the asset is one of the named objects, by its own name, or by a tag or category that equals it."""
        wanted = list(phrases)
        if self.facts is None:
            return self.named and names_object(leaf(self.asset), wanted)
        exact = phrases_of([str(self.facts.get("category") or ""), *map(str, self.facts.get("tags") or [])])
        return names_object(str(self.facts.get("name") or leaf(self.asset)), wanted) or any(
            phrase in exact for phrase in wanted
        )

    def says(self, phrase: tuple[str, ...]) -> bool:
        """Whether the asset's own text (name, tags, description) holds the phrase."""
        facts = self.facts or {"name": leaf(self.asset) if self.named else ""}
        texts = [str(facts.get("name") or ""), str(facts.get("description") or ""), *map(str, facts.get("tags") or [])]
        return any(has_phrase(text, phrase) for text in texts)


def leaf(path: str) -> str:
    """The last part of an asset path, without the class suffix ``_C``."""
    name = path.rstrip("'").rsplit("/", 1)[-1].rsplit(".", 1)[-1]
    return name.removesuffix("_C")


def trusted(path: str, known: Mapping[str, Any]) -> bool:
    """Whether a name is not the agent's: it is known, the engine's, or there is nothing to know it by."""
    return not known or path in known or path.lower().startswith("/engine/")


def inventory(snapshot: Mapping[str, Any], catalog: Mapping[str, Facts]) -> list[Thing]:
    """Every placed object of a snapshot: a Blueprint actor is one, each mesh component and each instance is one."""
    extra = snapshot.get("c4s")
    meshes: Mapping[str, Any] = (extra.get("meshes") or {}) if isinstance(extra, Mapping) else {}
    found: list[Thing] = []
    for actor in snapshot.get("actors") or []:
        if not isinstance(actor, Mapping) or not _shown(actor):
            continue
        class_path = str(actor.get("class") or "")
        own = actor.get("c4s")
        components = own.get("components") if isinstance(own, Mapping) else None
        if class_path.lower().startswith("/game/") or not isinstance(components, list):
            found.extend(_whole(actor, class_path, catalog))
        else:
            for component in components:
                found.extend(_parts(actor, component, meshes, catalog))
    return found


def _shown(actor: Mapping[str, Any]) -> bool:
    own = actor.get("c4s")
    return not (isinstance(own, Mapping) and own.get("hidden"))


def _facts(path: str, catalog: Mapping[str, Facts]) -> Facts | None:
    if path in catalog:
        return catalog[path]
    return catalog.get(path.removesuffix("_C")) or catalog.get(path + "." + path.rsplit("/", 1)[-1])


def _vector(record: Any, field: str) -> Array | None:
    value = record.get(field) if isinstance(record, Mapping) else None
    if not isinstance(value, list | tuple) or len(value) != 3:
        return None
    if not all(isinstance(v, int | float) and not isinstance(v, bool) for v in value):
        return None
    array = np.array(value, dtype=float)
    return array if np.isfinite(array).all() else None


def _materials(actor: Mapping[str, Any]) -> tuple[str, ...]:
    return tuple(str(path) for path in actor.get("material_paths") or [])


def _name(actor: Mapping[str, Any]) -> str:
    return str(actor.get("name") or actor.get("actor_path") or actor.get("label"))


def _whole(actor: Mapping[str, Any], class_path: str, catalog: Mapping[str, Facts]) -> list[Thing]:
    """A Blueprint actor, or an actor of a snapshot without components: one thing with the actor's bounds."""
    assets = [str(path) for path in actor.get("component_asset_paths") or [] if path]
    asset = class_path if class_path.lower().startswith("/game/") else str(actor.get("asset_path") or "")
    asset = asset or (assets[0] if len(assets) == 1 else "")
    origin, extent = (_vector(actor.get("bounds"), field) for field in ("origin_cm", "extent_cm"))
    if not asset or origin is None or extent is None:
        return []
    scale = _vector(actor.get("transform"), "scale")
    return [
        Thing(
            _name(actor),
            asset,
            _facts(asset, catalog),
            origin - extent,
            origin + extent,
            np.ones(3) if scale is None else scale,
            _materials(actor),
            trusted(asset, catalog),
        )
    ]


def _parts(
    actor: Mapping[str, Any], component: Mapping[str, Any], meshes: Mapping[str, Any], catalog: Mapping[str, Facts]
) -> list[Thing]:
    """The things of one mesh component: one, or one an instance."""
    asset = component.get("mesh")
    if not asset or component.get("visible") is False:
        return []
    mesh = meshes.get(asset)
    low, high = _vector(mesh, "bounds_min_cm"), _vector(mesh, "bounds_max_cm")
    instances = component.get("instances")
    placements = instances if isinstance(instances, list) else [component.get("transform")]
    parts = []
    for placement in placements:
        place = [_vector(placement, field) for field in ("location_cm", "rotation_deg", "scale")]
        if low is None or high is None or any(member is None for member in place):
            continue
        location, rotation, scale = (member.tolist() for member in place if member is not None)
        centre, half = transformed_box(affine(location, rotation, scale), low.tolist(), high.tolist())
        parts.append(
            Thing(
                _name(actor),
                str(asset),
                _facts(str(asset), catalog),
                centre - half,
                centre + half,
                np.array(scale),
                _materials(actor),
                trusted(str(asset), catalog),
            )
        )
    return parts
