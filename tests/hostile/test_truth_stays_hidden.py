"""A hostile agent looks for the truth through Python and through the tools, and finds nothing."""

from __future__ import annotations

import json

import pytest
from prey import SECRET, TRUTH, Prey

from c4s.toolbox.client import CallRefused

WALK = """
import os
found, read = [], 0
for top in ("/", "/tmp", os.getcwd(), os.path.expanduser("~"), {root!r}):
    for folder, _, files in os.walk(top):
        if folder.startswith(("/proc", "/sys")):
            continue
        for name in files:
            if "truth" in name or "withheld" in folder or name == "trajectory.jsonl":
                try:
                    open(os.path.join(folder, name)).read()
                    found.append(os.path.join(folder, name))
                except OSError:
                    pass
print("FOUND", found)
"""


def test_no_withheld_file_is_found_on_disk(prey: Prey) -> None:
    state = prey.python(WALK.format(root=str(prey.root)))
    assert "FOUND []" in state["output"], state


def test_the_asset_registry_holds_no_truth(prey: Prey) -> None:
    state = prey.python("""
import unreal
registry = unreal.AssetRegistryHelpers.get_asset_registry()
names = [str(one.package_name) for one in registry.get_assets_by_path("/Game", recursive=True)]
names += list(unreal.EditorAssetLibrary.list_assets("/Game", recursive=True))
print("NAMES", [name for name in names if "racle" in name or "ruth" in name], len(names) > 3)
for package in ("/Game/Oracle/room", "/Game/Withheld/room", "/Game/Test/Maps/Truth", "../withheld/room/truth",
                "/Game/../withheld/room/truth", "/Game/Oracle/../../withheld/room/truth"):
    for load in (unreal.EditorLoadingAndSavingUtils.load_map, unreal.EditorAssetLibrary.load_asset):
        try:
            got = load(package)
        except Exception as error:
            got = None
        print("LOADED" if got is not None else "no", package)
""")
    assert "NAMES [] True" in state["output"] and "LOADED" not in state["output"], state


def test_neither_keys_nor_the_token_are_in_the_engine(prey: Prey) -> None:
    state = prey.python("""
import os, sys
told = [repr(dict(os.environ)), repr(sys.argv)]
for pid in ["self", str(os.getppid()), *(name for name in os.listdir("/proc") if name.isdigit())] \\
        if os.path.isdir("/proc") and os.access("/proc", os.R_OK) else ["self"]:
    for part in ("environ", "cmdline"):
        try:
            told.append(open(f"/proc/{pid}/{part}", "rb").read().decode("latin-1"))
        except OSError:
            pass
print("TOLD", "\\n".join(told))
""")
    assert SECRET not in json.dumps(state) and prey.run.token not in json.dumps(state)
    assert "withheld" not in json.dumps(state)


@pytest.mark.parametrize(
    ("tool", "arguments"),
    [
        ("read_job_log", {"log_path": "../../suite/withheld/room/truth.level.json"}),
        ("read_job_log", {"job_id": "../truth"}),
        ("get_asset_preview", {"id": "../../suite/withheld/room/truth.level.json"}),
        ("get_asset_metadata", {"ids": ["/Game/Oracle/room.room", "../withheld"]}),
        ("spawn_actor", {"name": "T", "static_mesh": "/Game/Oracle/room", "location": [0, 0, 0]}),
        ("spawn_blueprint_actor", {"actor_name": "T", "blueprint_id": "/Game/Oracle/room", "location": [0, 0, 0]}),
        ("take_screenshot", {"filename": "../../suite/withheld/room/x"}),
        ("take_screenshot", {"filename": "..\\\\x"}),
        ("save_scene_as", {"name": "../../../withheld/room/truth"}),
        ("find_actors_by_name", {"pattern": "[" * 400 + "*" * 400}),
        ("build_tier", {"entries": [{"name": "T", "asset": "/Game/Oracle/room", "location": [0, 0, 0]}]}),
    ],
)
def test_no_tool_leads_to_the_truth(prey: Prey, tool: str, arguments: dict) -> None:
    with pytest.raises(CallRefused) as refused:
        prey.client.call(tool, **arguments)
    assert TRUTH not in str(refused.value)


def test_no_listing_tells_the_truth(prey: Prey) -> None:
    for tool, arguments in (
        ("get_actors_in_level", {}),
        ("find_actors_by_name", {"pattern": "*"}),
        ("search_assets", {"query": "globe truth oracle withheld crate"}),
        ("get_categories", {}),
        ("measure_scene", {}),
    ):
        assert TRUTH not in json.dumps(prey.client.call(tool, **arguments).data)
