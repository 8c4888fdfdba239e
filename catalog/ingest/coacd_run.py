"""Decomposes one mesh by coacd in a process of its own: ``python -m catalog.ingest.coacd_run`` (npz in, npz out).

A mesh that brings the native library down, or keeps it busy, then costs one mesh and not the build.
"""

from __future__ import annotations

import io
import json
import os
import resource
import sys

import numpy as np

CPU_LIMIT = "C4S_COACD_CPU_SECONDS"


def main() -> None:
    """Read vertices, faces and parameters from standard input, write the vertices of each part to standard output."""
    import coacd

    seconds = int(os.environ[CPU_LIMIT])
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    given = np.load(io.BytesIO(sys.stdin.buffer.read()), allow_pickle=False)
    out = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # coacd prints its progress
    coacd.set_log_level("error")
    parts = coacd.run_coacd(coacd.Mesh(given["vertices"], given["faces"]), **json.loads(str(given["parameters"])))
    np.savez(out, *[np.asarray(points, np.float64) for points, _ in parts])
    out.close()


if __name__ == "__main__":
    main()
