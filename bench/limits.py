"""What inputs beyond the bounds cost: ``python -m bench.limits`` prints a table; exit 1 when one costs too much.

Each input is read in a process of its own; the seconds are those of its processor, the memory its peak. The same rows
are a group of ``python -m bench limits``.
"""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import dataclass

from bench.row import Row
from c4s.bounds import BOUNDS

MOST_SECONDS, MOST_MIB = 30.0, 1500
_LEVEL = "from c4s.records.level import Level\nwork = lambda: Level.from_text(data, where='level')"
_ANSWER = "from c4s.engine.bridge import decode\nwork = lambda: decode(data)"
_MESH = "from c4s.packs.gltf_bounds import hold_tree\nwork = lambda: hold_tree(data, 'mesh')"
_CROWD = (
    "from c4s.collision import contacts\nfrom bench.contacts import city\nimport sys\nscene, _ = data\n"
    "for actor in scene['actors']: actor['c4s']['components'][0]['transform']['location_cm'] = [0, 0, 0]\n"
    "work = lambda: contacts(scene)"
)
_YAML = "from c4s.plain_yaml import parse_yaml\nwork = lambda: parse_yaml(data)"
_EDITS = (
    "import copy\nfrom c4s.protocol.settings import SETTINGS\nfrom c4s.verify.physics.verdict import verify_physics\n"
    "for actor in data['actors']:\n"
    "    actor['c4s']['components'][0]['transform']['location_cm'] = [0, 0, 100]\n"
    "    actor['transform'] = actor['c4s']['components'][0]['transform']\n"
    "    actor['bounds'] = {'origin_cm': [0, 0, 100], 'extent_cm': [50, 50, 50]}\n"
    "    actor['label'] = actor['name']\n"
    "    actor['class'] = '/Script/Engine.StaticMeshActor'\n"
    "setting = next(one for one in SETTINGS if one.endswith('indoor'))\n"
    "start = copy.deepcopy(data)\n"
    "for actor in start['actors']: actor['transform']['location_cm'] = [9000, 0, 100]\n"
    "leaf = lambda: verify_physics(setting, data, start).measurements['leaf_results'][0]\n"
    "def work():\n"
    "    found = leaf()\n"
    "    if found['status'] == 'measured': return found\n"
    "    raise ValueError(found['actors'][0]['reason'])"
)
INPUTS: dict[str, tuple[str, str]] = {
    "a level of 200 MiB of newlines": (r"b'\n' * (200 << 20)", _LEVEL),
    "a level of ten million empty lists": ("b'[' + b'[],' * (10 << 20) + b'0]'", _LEVEL),
    "a level with a million unknown keys": (
        "b'{' + b','.join(b'\"%d\":1' % n for n in range(1_000_000)) + b'}'",
        _LEVEL,
    ),
    "a level with a label of 30 MiB": (
        '(\'{"package":"/Game/A","actors":[{"name":"\' + \'x\' * (30 << 20) + \'"}]}\').encode()',
        _LEVEL,
    ),
    "a level with a number of 30 million digits": ("b'{\"package\":' + b'9' * (30 << 20) + b'}'", _LEVEL),
    "half a million actors": ('b\'{"package":"/Game/A","actors":[\' + b\'{"name":"A"},\' * 500_000 + b\'0]}\'', _LEVEL),
    "an answer of 48 MiB of empty lists": ("b'{\"a\":[' + b'[],' * (16 << 20) + b'0]}'", _ANSWER),
    "an answer of 150 MiB": ("b'{\"a\":\"' + b'x' * (150 << 20) + b'\"}'", _ANSWER),
    "an answer nested four million deep": ("b'{\"a\":' * (4 << 20)", _ANSWER),
    "a mesh of 2^40 nodes": ("{'nodes': [{'children': [n + 1] * 2} for n in range(40)] + [{'mesh': 0}]}", _MESH),
    "a mesh of 800 million numbers without data": (
        "{'accessors': [{'componentType': 5126, 'count': 50_000_000, 'type': 'MAT4'}]}",
        _MESH,
    ),
    "aliases in YAML that stand for 10^12 texts": (
        "'a0: &a0 x\\n' + ''.join(f'a{n}: &a{n} [' + f'*a{n - 1}, ' * 10 + ']\\n' for n in range(1, 13))",
        _YAML,
    ),
    "a merge key in YAML": ("'a: &a {k: 1}\\nb: {<<: [*a, *a]}\\n'", _YAML),
    "4,000 edited actors at one point": ("__import__('bench.contacts', fromlist=['city']).city(4000)[0]", _EDITS),
    "6,000 actors at one point": ("__import__('bench.contacts', fromlist=['city']).city(6000)", _CROWD),
}
_SCRIPT = """
import json, time
data = {data}
{reader}
began = time.process_time()
try:
    answer = type(work()).__name__
except Exception as error:
    answer = f"{{type(error).__name__}}: {{error}}"
used = time.process_time() - began
peak = next(int(line.split()[1]) for line in open("/proc/self/status") if line.startswith("VmHWM"))
print(json.dumps([answer, used, peak >> 10]))
"""


@dataclass(frozen=True)
class BoundHeld:
    """What became of an input."""

    name: str
    answer: str
    seconds: float
    memory_mib: int

    @property
    def met(self) -> bool:
        """Whether it was refused, in one line, within the declared time and memory."""
        refused = self.answer.startswith(("BadInput", "ValueError"))
        short = "\n" not in self.answer and len(self.answer) < 400
        return refused and short and self.seconds <= MOST_SECONDS and self.memory_mib <= MOST_MIB


def held(name: str) -> BoundHeld:
    """Read one of the inputs in a process of its own."""
    data, reader = INPUTS[name]
    script = _SCRIPT.format(data=data, reader=reader)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["nothing"])[-1]
        return BoundHeld(name, f"exit code {done.returncode}: {last}", 0.0, 0)
    return BoundHeld(name, *json.loads(done.stdout))


def rows() -> list[Row]:
    """A row an input: its seconds, with the answer and the memory in its name."""
    return [
        Row(
            f"{one.name} ({one.memory_mib} MiB; {one.answer[:90]})",
            one.seconds,
            f"refused, under {MOST_SECONDS:g} s and {MOST_MIB} MiB",
            one.met,
        )
        for one in map(held, INPUTS)
    ]


def main() -> int:
    """Print the table of ``docs/limits.md``: the bounds, then what is beyond them."""
    print("| limit | in | at most |\n|---|---|---|")
    for key, bound in BOUNDS.items():
        print(f"| `{key}` | {bound.what} | {bound.told()} |")
    print("\n| input | answer | seconds | MiB |\n|---|---|---|---|")
    found = [held(name) for name in INPUTS]
    for one in found:
        told = f"{'' if one.met else '**NOT HELD** '}{one.answer[:120]}"
        print(f"| {one.name} | {told} | {one.seconds:.1f} | {one.memory_mib} |")
    return 0 if all(one.met for one in found) else 1


if __name__ == "__main__":
    sys.exit(main())
