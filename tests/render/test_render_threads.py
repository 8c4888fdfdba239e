"""What a renderer starts beside the thread that asks for it."""

from __future__ import annotations

import subprocess
import sys

_BUILD = """
import os
import numpy as np
from c4s.packs.meshes import Mesh
from c4s.render import Instance, Lights, Renderer, SurfaceMaterial
side = 24
y, z = np.mgrid[0:side, 0:side].reshape(2, -1).astype(np.float32)
corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
faces = np.concatenate([corner[:, None] + (0, 1, side), corner[:, None] + (1, side + 1, side)]).astype(np.int32)
points = np.stack([np.zeros_like(y), y, z], axis=1)
mesh = Mesh(points, faces, np.tile(np.array([-1, 0, 0], np.float32), (side * side, 1)),
            np.zeros((side * side, 2), np.float32), np.zeros(len(faces), np.int32))
before = set(os.listdir("/proc/self/task"))
instances = [Instance(0, np.eye(4), (SurfaceMaterial(),), number) for number in range(200)]
kept = Renderer([mesh], instances, Lights(), threads=1)
print(len(set(os.listdir("/proc/self/task")) - before))
"""


def test_a_renderer_of_one_thread_starts_no_other() -> None:
    told = subprocess.run([sys.executable, "-c", _BUILD], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == "0", "a worker of Embree's spins for as long as the process lives"
