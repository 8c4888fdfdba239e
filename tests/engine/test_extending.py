"""Methods that a type gets from a module above its own are its own to everybody else."""

from __future__ import annotations

import inspect

import pytest

from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.unreal.core import extends


class Base:
    def own(self) -> int:
        return 1


class Derived(Base):
    pass


def test_a_type_and_what_derives_from_it_get_the_methods() -> None:
    @extends(Base)
    class More(Base):
        def twice(self) -> int:
            return 2 * self.own()

    assert Base().twice() == Derived().twice() == 2
    assert Base.twice.__qualname__ == "Base.twice" and issubclass(More, Base)


def test_a_method_is_declared_once() -> None:
    with pytest.raises(TypeError, match=r"Base\.own is declared twice"):

        @extends(Base)
        class _Again(Base):
            def own(self) -> int:
                return 2

    assert Base().own() == 1


def test_extended_types_show_their_methods_and_no_helper(tmp_path) -> None:
    unreal = boot([], tmp_path / "content")
    assert {"OfVector", "Directions", "Attachment", "Distances", "Noticing"}.isdisjoint(vars(unreal))
    for kind, name in (
        (unreal.Vector, "rotator"),
        (unreal.Vector, "distance"),
        (unreal.Transform, "to_matrix"),
        (unreal.Actor, "attach_to_actor"),
        (unreal.PrimitiveComponent, "ignore_actor_when_moving"),
    ):
        assert inspect.getattr_static(kind, name) is vars(kind)[name]
        assert vars(kind)[name].__qualname__ == f"{kind.__name__}.{name}"
    assert unreal.Plane(0, 0, 1, 5).rotator().pitch == 90
