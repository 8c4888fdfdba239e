"""The small case of the toolbox tests, a home of its own, and attempts against a scripted model."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration

for folder in ("toolbox", "meter", "agent_clients"):
    sys.path.insert(0, str(Path(__file__).parents[1] / folder))

PRICES = [
    {
        "model": "priced-1",
        "from": "2026-01-01",
        "input": 10,
        "output": 100,
        "cache_read": 1,
        "cache_write": 12,
        "source": "test",
    }
]


@pytest.fixture(scope="session")
def pack(tmp_path_factory: pytest.TempPathFactory) -> Path:
    from made_case import make_pack

    return make_pack(tmp_path_factory.mktemp("packs"))


@pytest.fixture
def attempt(tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., tuple[AttemptOutcome, Path]]:
    """Run an attempt of a client against a model endpoint: its outcome and its folder."""
    from made_case import make_case

    from c4s.run.attempt import run_attempt

    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("SCRIPTED_KEY", "the-real-key")
    monkeypatch.delenv("C4S_SPENDING_LIMIT_USD", raising=False)
    (tmp_path / "home").mkdir()
    (tmp_path / "home/prices.yaml").write_text(yaml.safe_dump({"prices": PRICES}))

    def start(
        client: str,
        url: str,
        *,
        model: str = "priced-1",
        options: dict[str, Any] | None = None,
        setting: str = "text-to-scene",
        **case_options: Any,
    ) -> tuple[AttemptOutcome, Path]:
        (tmp_path / "home/endpoints.yaml").write_text(
            yaml.safe_dump(
                {
                    "endpoints": {
                        "scripted": {
                            "url": url,
                            "formats": ["openai-chat", "openai-responses", "anthropic", "gemini"],
                            "key_env": "SCRIPTED_KEY",
                        }
                    }
                }
            )
        )
        case, agent_folder = make_case(tmp_path / "suite", pack, setting=setting, **case_options)
        configuration = Configuration(
            name=f"{client}-1", client=client, model=model, options={"endpoint": "scripted", **(options or {})}
        )
        folder = tmp_path / "run" / "attempt-1"
        return run_attempt(
            case, agent_folder, configuration, 1, folder, [pack], None, tmp_path / "run/spending.jsonl"
        ), folder

    return start
