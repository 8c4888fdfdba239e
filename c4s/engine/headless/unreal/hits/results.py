"""Hit results, and the two ways in which Unreal's Python returns "found it, and here it is"."""

from __future__ import annotations

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Literal

from c4s.engine.headless.queries.cast import Hit
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Prop, public
from c4s.engine.headless.unreal.structs import ClosedStruct, Vector

Layout = Literal["value", "pair"]
_layout: Layout = "value"


@contextmanager
def layout(kind: Layout) -> Iterator[None]:
    """Return results as the value or None, which is how Unreal does in 5.6 and as far as is known in 5.8, or as a
    ``pair`` of found and value, which scripts guard against."""
    global _layout
    before, _layout = _layout, kind
    try:
        yield
    finally:
        _layout = before


def returned(found: bool, value: Any) -> Any:
    """What a call that answers "found it" and a value returns."""
    if _layout == "pair":
        return found, value
    return value if found else None


def _shut(kind: str, default: Any) -> Prop:
    return Prop(kind, default, attribute=False, scripts=False)


@public
class HitResult(ClosedStruct):
    """What a trace hit; ``to_tuple()`` gives the fields in Unreal's order (there are no attributes)."""

    _fields = {
        "blocking_hit": _shut("bool", False),
        "initial_overlap": _shut("bool", False),
        "time": _shut("float", 1.0),
        "distance": _shut("float", 0.0),
        "location": _shut("Vector", Vector),
        "impact_point": _shut("Vector", Vector),
        "normal": _shut("Vector", Vector),
        "impact_normal": _shut("Vector", Vector),
        "phys_mat": _shut("None", None),
        "hit_actor": _shut("Actor | None", None),
        "hit_component": _shut("PrimitiveComponent | None", None),
        "hit_bone_name": _shut("Name", Name),
        "bone_name": _shut("Name", Name),
        "hit_item": _shut("int", -1),
        "element_index": _shut("int", -1),
        "face_index": _shut("int", -1),
        "trace_start": _shut("Vector", Vector),
        "trace_end": _shut("Vector", Vector),
    }
    _depth = 0.0

    @classmethod
    def _of(cls, hit: Hit, start: Vector, end: Vector) -> HitResult:
        length = start.distance(end)
        made = cls.__new__(cls)
        made.__dict__.update(
            {
                "blocking_hit": hit.blocking,
                "initial_overlap": hit.initial,
                "time": hit.distance / length if length > 0 else 0.0,
                "distance": hit.distance,
                "location": _vector(hit.location),
                "impact_point": _vector(hit.point),
                "normal": _vector(hit.normal),
                "impact_normal": _vector(hit.face_normal),
                "phys_mat": None,
                "hit_actor": hit.target.actor,
                "hit_component": hit.target.component,
                "hit_bone_name": Name(),
                "bone_name": Name(),
                "hit_item": hit.target.item,
                "element_index": hit.element,
                "face_index": hit.face,
                "trace_start": start.copy(),
                "trace_end": end.copy(),
                "_depth": hit.depth,
            }
        )
        return made

    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""
        return {n: self.__dict__[n] for n in self._fields}

    def copy(self) -> Any:
        """A copy."""
        made = super().copy()
        made.__dict__["_depth"] = self._depth
        return made

    def export_text(self) -> str:
        """Unreal's text form; it also tells the penetration depth (cm), which no field shows."""
        return f"{super().export_text()[:-1]},PenetrationDepth={self._depth:.6f})"

    def __repr__(self) -> str:
        return f"<Struct 'HitResult' {{{', '.join(f'{n}: {v!r}' for n, v in self.to_dict().items())}}}>"


def _vector(row: Any) -> Vector:
    return Vector(float(row[0]) + 0.0, float(row[1]) + 0.0, float(row[2]) + 0.0)


def first(hits: Sequence[Hit], start: Vector, end: Vector) -> Any:
    """The one hit as a call returns it."""
    return returned(bool(hits), HitResult._of(hits[0], start, end) if hits else HitResult())


def many(hits: Sequence[Hit], start: Vector, end: Vector) -> Any:
    """All hits as a call returns them; without one that blocks, Unreal returns None."""
    results = Array._of("HitResult", [HitResult._of(hit, start, end) for hit in hits])
    return returned(any(hit.blocking for hit in hits), results)
