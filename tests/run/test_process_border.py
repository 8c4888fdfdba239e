"""Every error of c4s crosses a process border whole: class, fields, line and exit code."""

from __future__ import annotations

import asyncio
import importlib
import inspect
import pickle
import pkgutil
from collections.abc import Iterator
from typing import Any, NoReturn

import pytest

import c4s
from c4s.errors import C4SError
from c4s.run.limits import Limit
from c4s.run.pool import Pool

INSIDE_ENGINES = (
    "c4s.editor.",
    "c4s.engine.headless.process.",
    "c4s.engine.headless.unreal.",
    "c4s.engine.unreal.boot.",
    "c4s.harness.inspecting",
)
"""Modules that are only ever imported where a module ``unreal`` is, or Inspect."""


def _kinds() -> list[type[C4SError]]:
    """All error classes of the package, found in every module that the evaluator imports."""
    for found in pkgutil.walk_packages(c4s.__path__, "c4s."):
        if not found.name.endswith("__main__") and not found.name.startswith(INSIDE_ENGINES):
            importlib.import_module(found.name)
    return sorted(_below(C4SError), key=lambda kind: f"{kind.__module__}.{kind.__qualname__}")


def _below(kind: type[C4SError]) -> Iterator[type[C4SError]]:
    if kind.__module__.startswith("c4s."):
        yield kind
    for child in kind.__subclasses__():
        yield from _below(child)


def _made(kind: type[C4SError]) -> C4SError:
    """An error with a text in every parameter that its constructor takes."""
    given: dict[str, Any] = {
        name: [f"a {name}"] if "Sequence" in str(parameter.annotation) else f"a {name}\nof two lines"
        for name, parameter in inspect.signature(kind).parameters.items()
    }
    return kind(**given)


def _raise(error: C4SError) -> NoReturn:
    raise error


def _same(one: BaseException, other: BaseException) -> None:
    assert isinstance(one, C4SError) and type(one) is type(other) and one.args == other.args
    fields = {name: value for name, value in vars(one).items() if name != "__notes__"}
    assert fields == {name: value for name, value in vars(other).items() if name != "__notes__"}
    assert isinstance(other, C4SError) and (one.line(), one.exit_code) == (other.line(), other.exit_code)


def test_every_error_is_the_same_after_a_pickle_and_after_a_worker_process() -> None:
    kinds = _kinds()
    assert {"BadInput", "EngineCallError", "EngineDied", "SpendingLimitReached"} <= {kind.__name__ for kind in kinds}

    async def cross() -> None:
        async with Pool(1) as pool:
            for kind in kinds:
                error = _made(kind)
                _same(pickle.loads(pickle.dumps(error)), error)
                with pytest.raises(kind) as raised:
                    await pool.run(Limit("processor", 60.0), _raise, error)
                _same(raised.value, error)

    asyncio.run(cross())
