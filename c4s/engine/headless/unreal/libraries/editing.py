"""System functions for edits: transactions, printing, facts of objects, parameters of the process.

Transactions open and close; there is no undo, so cancelling one keeps what was edited, as cancelling does in Unreal.
"""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.components import PrimitiveComponent
from c4s.engine.headless.unreal.containers import Array, Name, Text
from c4s.engine.headless.unreal.core import Class, Object, api, as_class
from c4s.engine.headless.unreal.structs import LinearColor, Vector

_BLUE = (0.0, 0.66, 1.0, 1.0)


class Editing:
    """Functions of ``unreal.SystemLibrary`` that look at or announce edits."""

    @classmethod
    @api
    def begin_transaction(cls, context: str, description: Text | str, primary_object: Object | None) -> int:
        """Open a transaction; gives its index, 0 for the outermost."""
        world().transactions.append(str(description))
        return len(world().transactions) - 1

    @classmethod
    @api
    def end_transaction(cls) -> int:
        """Close the innermost transaction; gives its index, -1 when none is open."""
        if world().transactions:
            world().transactions.pop()
            return len(world().transactions)
        return -1

    @classmethod
    @api
    def cancel_transaction(cls, index: int) -> None:
        """Drop the transactions from an index on; what they edited stays."""
        del world().transactions[max(0, index) :]

    @classmethod
    @api
    def transact_object(cls, object: Object) -> None:
        """Announce an edit of an object."""
        object.modify()

    @classmethod
    @api
    def snapshot_object(cls, object: Object) -> None:
        """Announce an edit of an object."""
        object.modify()

    @classmethod
    @api
    def print_string(
        cls,
        world_context_object: Object | None,
        string: str = "Hello",
        print_to_screen: bool = True,
        print_to_log: bool = True,
        text_color: LinearColor = _BLUE,  # type: ignore[assignment]
        duration: float = 2.0,
        key: Name | str = "None",
    ) -> None:
        """Log a line."""
        if print_to_log:
            world().log.display(str(string))

    @classmethod
    @api
    def print_text(
        cls,
        world_context_object: Object | None,
        text: Text | str = "Hello",
        print_to_screen: bool = True,
        print_to_log: bool = True,
        text_color: LinearColor = _BLUE,  # type: ignore[assignment]
        duration: float = 2.0,
        key: Name | str = "None",
    ) -> None:
        """Log a line."""
        if print_to_log:
            world().log.display(str(text))

    @classmethod
    @api
    def log_string(cls, string: str = "Hello", print_to_log: bool = True) -> None:
        """Log a line."""
        if print_to_log:
            world().log.display(str(string))

    @classmethod
    @api
    def get_actor_bounds(cls, actor: Actor) -> tuple[Vector, Vector]:
        """World AABB of an actor: centre and half extent in cm."""
        return actor.get_actor_bounds(False)

    @classmethod
    @api
    def get_actor_list_from_component_list(
        cls, component_list: Sequence[PrimitiveComponent], actor_class_filter: Class | type | None
    ) -> Array:
        """Actors that own components, each once."""
        wanted = as_class(actor_class_filter)._python_type if actor_class_filter is not None else Actor
        owners = dict.fromkeys(c.get_owner() for c in component_list)
        return Array._of("Actor", [a for a in owners if isinstance(a, wanted)])

    @classmethod
    @api
    def get_class_display_name(cls, class_: Class | type) -> str:
        """Name of a class."""
        return as_class(class_).get_name()

    @classmethod
    @api
    def is_valid_class(cls, class_: Class | type | None) -> bool:
        """Whether a class is one."""
        return class_ is not None

    @classmethod
    @api
    def get_outer_object(cls, object: Object) -> Object | None:
        """What an object lies in."""
        return object.get_outer()

    @classmethod
    @api
    def get_system_path(cls, object: Object) -> str:
        """Path and file of an object; files are not told here."""
        return ""

    @classmethod
    @api
    def does_implement_interface(cls, test_object: Object, interface: Class | type) -> bool:
        """Interfaces do not exist here."""
        return False

    @classmethod
    @api
    def is_unattended(cls) -> bool:
        """Nobody sits at this editor."""
        return True

    @classmethod
    @api
    def get_game_name(cls) -> str:
        """Name of the project."""
        return world().content.parent.name

    @classmethod
    @api
    def get_game_time_in_seconds(cls, world_context_object: Object | None) -> float:
        """No game is played here."""
        return 0.0

    @classmethod
    @api
    def get_console_variable_int_value(cls, variable_name: str) -> int:
        """There are no console variables: 0."""
        return 0

    @classmethod
    @api
    def get_console_variable_float_value(cls, variable_name: str) -> float:
        """There are no console variables: 0."""
        return 0.0
