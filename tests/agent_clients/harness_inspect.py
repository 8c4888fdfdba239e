"""A case in Inspect AI: with a mock model that saves the scene, one that only answers, and by Inspect's own command."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path

from harness_made import Made

RUN = """
import sys
from inspect_ai import eval
from inspect_ai.model import ModelOutput, ModelUsage, get_model
from c4s.harness.inspecting import starter
def output(made):
    made.usage = ModelUsage(input_tokens=100, output_tokens=10, total_tokens=110)
    return made
call = ModelOutput.for_tool_call
outputs = [call("mockllm/model", "save_scene_as", {"name": "saved"}), ModelOutput.from_content("mockllm/model", "done")]
model = get_model("mockllm/model", custom_outputs=[output(made) for made in outputs[int(sys.argv[2]):]])
(log,) = eval(starter(cases=sys.argv[1]), model=model, log_dir=sys.argv[3], display="none")
assert log.status == "success", log.error
(sample,) = log.samples
score = sample.scores["case_score"]
print(__import__("json").dumps({"value": score.value, "metadata": score.metadata, "tools": len(sample.messages)}))
"""
COMMAND = ("eval", "c4s/starter", "--model", "mockllm/model", "--display", "none", "--log-format", "json")


def run(place: Path, case: str) -> list[Made]:
    """A reward for a model that only answers, by the command, and for one that saves the scene as it is."""
    site = next((place / "lib").glob("python3*")) / "site-packages"
    tokens = site / "litellm/litellm_core_utils/tokenizers"
    environment = {**os.environ, **({"TIKTOKEN_CACHE_DIR": str(tokens)} if tokens.is_dir() else {})}
    made = []
    with tempfile.TemporaryDirectory(prefix="c4s-inspect-") as folder:
        for agent, skipped, expected in (("saving", 0, 0.2), ("silent", 1, 0.0)):
            done = subprocess.run(
                [str(place / "bin/python"), "-c", RUN, case, str(skipped), folder],
                env=environment,
                capture_output=True,
                text=True,
                check=False,
            )
            if done.returncode:
                made.append(Made(agent, None, expected, done.stderr[-400:]))
                continue
            found = json.loads(done.stdout.splitlines()[-1])
            (outcome,) = Path(found["metadata"]["folder"]).rglob("attempt-1/outcome.json")
            kept = json.loads(outcome.read_text())
            note = (
                f"{kept['tool_calls']} calls, {kept['input_tokens']} in and {kept['output_tokens']} out in c4s's books"
            )
            made.append(Made(agent, found["value"]["reward"], expected, note))
        made.append(_by_command(place, case, environment, Path(folder)))
    return made


def _by_command(place: Path, case: str, environment: dict[str, str], folder: Path) -> Made:
    logs = folder / "logs"
    command = [str(place / "bin/inspect"), *COMMAND, "-T", f"cases={case}", "--log-dir", str(logs)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    found = [json.loads(path.read_text()) for path in logs.glob("*.json")]
    if not found or found[0]["status"] != "success":
        return Made("command", None, 0.0, (done.stdout + done.stderr)[-400:])
    value = found[0]["samples"][0]["scores"]["case_score"]["value"]
    return Made("command", value["reward"], 0.0, " ".join(COMMAND[:4]))
