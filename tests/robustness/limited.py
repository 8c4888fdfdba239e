"""What a piece of work costs in a process of its own: its answer, seconds and peak memory."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import NamedTuple

_PREAMBLE = """
import json, resource, sys, time
from c4s.errors import BadInput
resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
resource.setrlimit(resource.RLIMIT_CPU, (CPU, CPU))
def told(work):
    try:
        found = work()
    except BadInput as error:
        found = error.line()
    with open("/proc/self/status") as status:
        peak = next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))
    print(json.dumps([str(found), time.process_time(), peak >> 10]))
"""


class Cost(NamedTuple):
    """The answer in one line, processor seconds, and the most memory (MiB) that it held."""

    answer: str
    seconds: float
    memory_mib: int


def cost(script: str, *, memory_mib: int = 3072, cpu_s: int = 60) -> Cost:
    """Run a script that ends with ``told(work)``; ``AssertionError`` with its errors when it does not get there."""
    text = f"MEMORY, CPU = {memory_mib << 20}, {cpu_s}\n{_PREAMBLE}{script}"
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"exit {done.returncode}: {done.stderr[-2000:]}"
    answer, seconds, peak = json.loads(done.stdout.splitlines()[-1])
    assert "\n" not in answer
    return Cost(answer, seconds, peak)
