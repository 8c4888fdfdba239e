"""What an editor's own Python runs: the copy in a project, with nothing but the standard library and ``unreal``."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from c4s.engine.unreal.host.session import EditorSession

IMPORT_ALL = """
import importlib, pathlib, sys, types
class Anything(types.ModuleType):
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return type(name, (), {})
sys.modules["unreal"] = Anything("unreal")
root = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(root))
for file in sorted(root.rglob("*.py")):
    importlib.import_module(".".join(file.relative_to(root).with_suffix("").parts).removesuffix(".__init__"))
known = {*sys.stdlib_module_names, "c4s", "__main__"}
print(sorted(name for name in sys.modules if name.partition(".")[0] not in known))
"""


def test_the_copy_in_a_project_needs_no_package(session: EditorSession, tmp_path: Path) -> None:
    modules = tmp_path / "scratch/project/Start/modules"
    done = subprocess.run(
        [sys.executable, "-I", "-S", "-c", IMPORT_ALL, str(modules)], capture_output=True, text=True, check=False
    )
    assert done.stdout.strip() == "['unreal']", done.stderr
