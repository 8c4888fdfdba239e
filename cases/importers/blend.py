"""A Blender file as a scene: Blender itself, where it is installed, writes it as glTF, which is read as any other.

Scripts in the file are not run. Things that are hidden from renders or whose collection is are left out by Blender's
exporter; modifiers are applied, and lights and cameras come along.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from pathlib import Path
from string import Template

from c4s.errors import BadInput
from cases.importers.gltf import read_tree
from cases.importers.imported import ImportedScene

BLENDER = "blender"
TIMEOUT_S = 600
_EXPORT = Template("""
import bpy
bpy.ops.export_scene.gltf(
    filepath=$out, export_format="GLB", use_visible=True, use_renderable=True, export_apply=$apply,
    export_cameras=True, export_lights=True, export_animations=False, export_skins=False, export_morph=False)
""")


def read_blend(path: Path, *, scale: float = 1.0) -> ImportedScene:
    """Read the scene that a Blender file opens with.

    Args:
        path: the file.
        scale: metres per unit of the file.

    Raises:
        BadInput: Blender is not installed, or cannot read or export the file.
    """
    program = shutil.which(BLENDER)
    if program is None:
        raise BadInput(
            "a Blender file is read by Blender, which is not installed",
            where=str(path),
            todo="install Blender, or export the file as GLB",
        )
    with tempfile.TemporaryDirectory(prefix="c4s-blend-") as folder:
        out, script = Path(folder) / f"{path.stem}.glb", Path(folder) / "export.py"
        for apply in (True, False):
            script.write_text(_EXPORT.substitute(out=repr(str(out)), apply=apply), encoding="utf-8")
            told = _run(
                [program, "--background", "--disable-autoexec", str(path.resolve()), "--python", str(script)], path
            )
            if out.is_file():
                scene = read_tree(out, scale=scale)
                if not apply:
                    scene.note(path.name, "its modifiers cannot be applied and are left out")
                return scene
    raise BadInput(f"Blender cannot export this file: {told[-1] if told else 'it says nothing'}", where=str(path))


def _run(command: list[str], path: Path) -> list[str]:
    """Runs Blender; the lines that it said last."""
    try:
        done = subprocess.run(command, capture_output=True, timeout=TIMEOUT_S, check=False)
    except subprocess.TimeoutExpired:
        raise BadInput(f"Blender has not written this file within {TIMEOUT_S} s", where=str(path)) from None
    said = (done.stdout + done.stderr).decode("utf-8", "replace").splitlines()
    return [line.strip() for line in said if line.strip() and "Error" in line][-3:]
