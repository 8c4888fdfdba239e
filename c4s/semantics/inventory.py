"""The inventory of a scene: one thing an object that was placed, with the facts of its asset and its world box.

A thing is known by its asset (catalog name, category, tags, description) or, where the catalog does not know the asset,
by the last part of the asset's path. Actor labels are chosen by the agent under test and are never read; so are the
names of assets that it made itself: where there is a catalog, an asset that it does not hold has no name (an engine
shape has).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.geometry.transform import WORLD_CM, affine, transformed_box
from c4s.semantics.kinds import Facts, ThingKind

Array: TypeAlias = NDArray[np.float64]
Box: TypeAlias = tuple[Array, Array]
"""Least and most corner (cm)."""


@dataclass(frozen=True, eq=False)
class Thing:
    """One placed object. ``low`` and ``high`` are its world box in cm, cut off at the edge of the largest world."""

    actor: str
    kind: ThingKind
    low: Array
    high: Array
    scale: Array
    materials: tuple[str, ...]
    """Paths of the materials that the actor shows."""
    collision: bool | None = None
    """Whether it collides although its asset could; null where its asset has no collision or nobody says."""

    @property
    def centre(self) -> Array:
        """Centre of the box (cm)."""
        return (self.low + self.high) / 2


def trusted(path: str, known: Mapping[str, Any]) -> bool:
    """Whether a name is not the agent's: it is known, the engine's, or there is nothing to know it by."""
    return not known or path in known or path.lower().startswith("/engine/")


def inventory(snapshot: Mapping[str, Any], catalog: Mapping[str, Facts]) -> list[Thing]:
    """Every placed object of a snapshot: a Blueprint actor is one, each mesh component and each instance is one.

    What is hidden (an actor, or one component of it) is not placed; a snapshot that does not say so hides nothing.
    """
    return placed(snapshot, catalog)[0]


def placed(snapshot: Mapping[str, Any], catalog: Mapping[str, Facts]) -> tuple[list[Thing], int]:
    """The ``inventory`` of a snapshot, and how many things it shows of which nobody can say where they are: their mesh
    has no bounds there, or their place is no number."""
    reader = _Reader(snapshot, catalog)
    return list(reader.things(snapshot.get("actors") or [])), reader.unread


def landscapes(snapshot: Mapping[str, Any]) -> list[Box]:
    """World boxes of the landscapes that a snapshot shows."""
    boxes = []
    for actor in snapshot.get("actors") or []:
        if isinstance(actor, Mapping) and str(actor.get("class") or "").startswith("/Script/Landscape."):
            origin, extent = (_vector(actor.get("bounds"), field) for field in ("origin_cm", "extent_cm"))
            if origin is not None and extent is not None:
                boxes.append((origin - extent, origin + extent))
    return boxes


def unmeshed(snapshot: Mapping[str, Any]) -> set[str]:
    """Classes of the shown actors that are the engine's own and no things: lights, landscapes, skies, decals."""
    found = set()
    for actor in snapshot.get("actors") or []:
        if isinstance(actor, Mapping) and _shown(actor):
            path = str(actor.get("class") or "")
            if path.startswith("/Script/") and not path.endswith("MeshActor"):
                found.add(path)
    return found


class _Reader:
    """Reads the things of one snapshot; each asset is looked up once."""

    def __init__(self, snapshot: Mapping[str, Any], catalog: Mapping[str, Facts]) -> None:
        extra = snapshot.get("c4s")
        self._meshes: Mapping[str, Any] = (extra.get("meshes") or {}) if isinstance(extra, Mapping) else {}
        self._catalog = catalog
        self._kinds: dict[str, ThingKind] = {}
        self.unread = 0
        """Things without a place that can be read, so far."""

    def things(self, actors: Iterable[Any]) -> Iterator[Thing]:
        """The things of actors, in their order."""
        for actor in actors:
            if not isinstance(actor, Mapping) or not _shown(actor):
                continue
            class_path = str(actor.get("class") or "")
            own = actor.get("c4s")
            components = own.get("components") if isinstance(own, Mapping) else None
            if class_path.lower().startswith("/game/") or not isinstance(components, list):
                yield from self._whole(actor, class_path)
                continue
            name, materials = _name(actor), _materials(actor)
            for component in components:
                if isinstance(component, Mapping) and component.get("mesh") and component.get("visible", True):
                    yield from self._parts(name, materials, component)

    def _kind(self, path: str) -> ThingKind:
        if path not in self._kinds:
            known = catalog_path(path, self._catalog)
            facts = None if known is None else self._catalog[known]
            self._kinds[path] = ThingKind(path, facts, trusted(path, self._catalog))
        return self._kinds[path]

    def _whole(self, actor: Mapping[str, Any], class_path: str) -> Iterator[Thing]:
        """A Blueprint actor, or an actor of a snapshot without components: one thing with the actor's bounds."""
        assets = [str(path) for path in actor.get("component_asset_paths") or [] if path]
        asset = class_path if class_path.lower().startswith("/game/") else str(actor.get("asset_path") or "")
        asset = asset or (assets[0] if len(assets) == 1 else "")
        origin, extent = (_vector(actor.get("bounds"), field) for field in ("origin_cm", "extent_cm"))
        if not asset:
            return
        if origin is None or extent is None:
            self.unread += 1
            return
        scale = _vector(actor.get("transform"), "scale")
        yield _thing(
            _name(actor),
            self._kind(asset),
            origin,
            extent,
            np.ones(3) if scale is None else scale,
            _materials(actor),
            _collides(actor),
        )

    def _parts(self, name: str, materials: tuple[str, ...], component: Mapping[str, Any]) -> Iterator[Thing]:
        """The things of one mesh component: one, or one an instance."""
        asset = str(component["mesh"])
        mesh = self._meshes.get(component["mesh"])
        low, high = _vector(mesh, "bounds_min_cm"), _vector(mesh, "bounds_max_cm")
        if low is None or high is None:
            self.unread += 1
            return
        kind = self._kind(asset)
        collides = bool(component.get("collision_enabled")) if mesh and mesh.get("collision") else None
        instances = component.get("instances")
        for placement in instances if isinstance(instances, list) else [component.get("transform")]:
            location, rotation = _vector(placement, "location_cm"), _vector(placement, "rotation_deg")
            scale = _vector(placement, "scale")
            if location is not None and rotation is not None and scale is not None:
                matrix = affine(location.tolist(), rotation.tolist(), scale.tolist())
                centre, half = transformed_box(matrix, low.tolist(), high.tolist())
                yield _thing(name, kind, centre, half, scale, materials, collides)
            else:
                self.unread += 1


def _thing(
    name: str,
    kind: ThingKind,
    centre: Array,
    half: Array,
    scale: Array,
    materials: tuple[str, ...],
    collision: bool | None,
) -> Thing:
    low, high = np.clip([centre - half, centre + half], -WORLD_CM, WORLD_CM)
    return Thing(name, kind, low, high, scale, materials, collision)


def _collides(actor: Mapping[str, Any]) -> bool | None:
    """Whether an actor collides; null where its record does not say."""
    told = actor.get("collision")
    enabled = told.get("collision_enabled") if isinstance(told, Mapping) else None
    return enabled if isinstance(enabled, bool) else None


def _shown(actor: Mapping[str, Any]) -> bool:
    """Whether no record of the actor says that it is hidden: its own, that of its properties, that of c4s, nor that of
    the editor, which takes the pictures."""
    told = actor.get("export_diagnostics")
    if isinstance(told, Mapping) and told.get("hidden_in_editor"):
        return False
    records = (actor, actor.get("properties"), actor.get("c4s"))
    return not any(isinstance(record, Mapping) and record.get("hidden") for record in records)


def catalog_path(path: str, catalog: Mapping[str, Facts]) -> str | None:
    """The path under which a catalog holds an asset: as it is, without a class's suffix, or with the object's name."""
    for known in (path, path.removesuffix("_C"), path + "." + path.rsplit("/", 1)[-1]):
        if known in catalog:
            return known
    return None


def _vector(record: Any, field: str) -> Array | None:
    """Three finite numbers, each cut off at the size of the largest world."""
    value = record.get(field) if isinstance(record, Mapping) else None
    if not isinstance(value, list | tuple) or len(value) != 3:
        return None
    for number in value:
        if isinstance(number, bool) or not isinstance(number, int | float) or not -math.inf < number < math.inf:
            return None
    return np.array([min(max(v, -WORLD_CM), WORLD_CM) for v in value], dtype=float)


def _materials(actor: Mapping[str, Any]) -> tuple[str, ...]:
    return tuple(str(path) for path in actor.get("material_paths") or [])


def _name(actor: Mapping[str, Any]) -> str:
    return str(actor.get("name") or actor.get("actor_path") or actor.get("label"))
