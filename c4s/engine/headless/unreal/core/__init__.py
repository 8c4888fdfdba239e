"""The strict object model of the ``unreal`` module: checked calls, editor properties, classes and objects.

An unknown name is an ``AttributeError``, a wrong number or type of arguments a ``TypeError``, an unknown editor
property an ``Exception``: as in Unreal's own Python.
"""

from __future__ import annotations

from c4s.engine.headless.unreal.containers.items import register
from c4s.engine.headless.unreal.containers.live import copied
from c4s.engine.headless.unreal.core.checks import TYPES, api, camel, deprecated, fits, need, public
from c4s.engine.headless.unreal.core.enumeration import EnumBase
from c4s.engine.headless.unreal.core.extending import extends
from c4s.engine.headless.unreal.core.items import ItemRules
from c4s.engine.headless.unreal.core.objects import Class, Object, Package, as_class, subclass_of
from c4s.engine.headless.unreal.core.properties import ObjectBase, Prop, converted, named
from c4s.engine.headless.unreal.core.setters import with_setters

register(ItemRules())

__all__ = [
    "TYPES",
    "Class",
    "EnumBase",
    "Object",
    "ObjectBase",
    "Package",
    "Prop",
    "api",
    "as_class",
    "camel",
    "converted",
    "copied",
    "deprecated",
    "extends",
    "fits",
    "named",
    "need",
    "public",
    "subclass_of",
    "with_setters",
]
