"""What an engine does not load: its start is paid by every attempt and by every submission."""

from __future__ import annotations

import subprocess
import sys

_LOADED = (
    "import sys; print(sorted({name.partition('.')[0] for name in sys.modules} & {'coal', 'fcl', 'numba', 'scipy'}))"
)


def _told(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def test_an_engine_that_is_asked_nothing_loads_no_library_of_collision_and_no_compiler() -> None:
    assert _told(f"import c4s.engine.headless.process.boot; {_LOADED}") == "[]"


def test_the_first_picture_loads_no_linear_algebra() -> None:
    code = (
        "from c4s.engine.headless.pictures.take import warm; warm(); import sys; print('scipy.linalg' in sys.modules)"
    )
    assert _told(code) == "False"


def test_compiled_code_that_needs_linear_algebra_gets_it() -> None:
    code = """
import numba, numpy
from c4s.compiled import _leave_out_linear_algebra
_leave_out_linear_algebra()
print(numba.njit(lambda a: numpy.dot(a, a))(numpy.ones(3)))
"""
    assert _told(code) == "3.0"
