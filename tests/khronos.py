"""What the Khronos validator says of a GLB file. Needs node and the npm package ``gltf-validator`` (``NODE_PATH``)."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

SCRIPT = (
    "require('gltf-validator').validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1])))"
    ".then(found => console.log(JSON.stringify(found.issues)))"
)


def complaints(file: Path) -> list[dict[str, Any]]:
    """The validator's messages on a file; the test is skipped where there is no validator."""
    if shutil.which("node") is None:
        pytest.skip("node is not installed")
    if subprocess.run(["node", "-e", "require.resolve('gltf-validator')"], capture_output=True, check=False).returncode:
        pytest.skip("the npm package gltf-validator is not installed")
    done = subprocess.run(["node", "-e", SCRIPT, str(file)], capture_output=True, text=True, check=True)
    messages: list[dict[str, Any]] = json.loads(done.stdout)["messages"]
    return messages
