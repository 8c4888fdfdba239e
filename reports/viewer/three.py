"""three.js as one classic script, out of the locked set-up: trimesh carries it for its own viewer."""

from __future__ import annotations

import zipfile
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from c4s.errors import MachineryFault

_BEGIN: Final = "/**\n * @license\n"
_END: Final = "}));\n(function(){"
"""What comes after it there are controls and a loader that are not used here."""
_KEPT: Final = len("}));\n")
LICENCE: Final = """\
The MIT License

Copyright © 2010-2022 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
"""
"""Of three.js; it lies beside the script."""


@cache
def three_script() -> bytes:
    """The script; it makes the global ``THREE``. ``MachineryFault`` where trimesh does not carry it as it did."""
    found = find_spec("trimesh")
    if found is None or found.origin is None:
        raise MachineryFault("trimesh is not installed, and pages need its three.js")
    archive = Path(found.origin).parent / "resources" / "templates" / "viewer.zip"
    with zipfile.ZipFile(archive) as inside:
        page = inside.read(inside.namelist()[0]).decode()
    begin = page.find(_BEGIN)
    end = page.find(_END, begin)
    if begin < 0 or end < 0:
        raise MachineryFault("trimesh carries no three.js of the kind that pages need", where=str(archive))
    return page[begin : end + _KEPT].encode()
