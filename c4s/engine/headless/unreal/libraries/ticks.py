"""Functions that run after each tick."""

from __future__ import annotations

from collections.abc import Callable

_ticks: dict[int, Callable[[float], None]] = {}


def register_slate_post_tick_callback(callable: Callable[[float], None]) -> object:
    """Register a function that is called after each tick; returns a handle."""
    handle = object()
    _ticks[id(handle)] = callable
    return _Handle(id(handle), handle)


def unregister_slate_post_tick_callback(handle: object) -> None:
    """Forget a tick function."""
    if not isinstance(handle, _Handle):
        raise TypeError("unregister_slate_post_tick_callback: not a handle")
    _ticks.pop(handle.number, None)


class _Handle:
    def __init__(self, number: int, anchor: object) -> None:
        self.number, self.anchor = number, anchor


def ticking() -> bool:
    """Whether there are tick functions."""
    return bool(_ticks)


def tick(delta_seconds: float) -> None:
    """Call the tick functions once (the server does so between requests)."""
    for number in list(_ticks):
        if number in _ticks:  # an earlier one may have taken it back
            _ticks[number](delta_seconds)
