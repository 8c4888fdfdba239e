"""``python -m c4s.engine.unreal.standin install FOLDER``, and ``... content PACK`` for each pack that it shall show."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

from c4s.engine.unreal.standin.content import add_content
from c4s.engine.unreal.standin.install import install
from c4s.errors import C4SError


def main(arguments: list[str]) -> int:
    """Install the stand-in and print the variables that c4s needs; or add content to a pack. The exit code."""
    try:
        match arguments:
            case ["install", folder]:
                for name, value in install(Path(folder)).items():
                    print(f"export {name}={shlex.quote(value)}")
            case ["content", pack]:
                add_content(Path(pack))
            case _:
                print(__doc__, file=sys.stderr)
                return 2
    except C4SError as error:
        print(f"c4s: {error.line()}", file=sys.stderr)
        return error.exit_code
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
