"""The exceptions from the house rules, each with what it may hold and why."""

from __future__ import annotations

RUN_FILES: dict[str, set[str]] = {
    "bench/attacks/trial.py": {"submission", "trajectory.jsonl"},
    "bench/attacks/writing.py": {"manifest.json", "outcome.json", "trajectory.jsonl"},
    "c4s/errors.py": {"faults.jsonl"},
}
"""An attack tries to write there from inside of an engine, as agent code would spell it; advice names a file."""

SETTINGS: dict[str, set[str]] = {}

VERIFIERS: dict[str, set[str]] = {
    "bench/instant.py": {"integrity"},
    "bench/leaderboard.py": {"detailed", "overview", "physics"},
    "bench/made_verdicts.py": {"detailed", "repair"},
    "bench/made_warehouse.py": {"detailed", "overview", "physics"},
    "bench/night.py": {"integrity"},
    "bench/orchestration.py": {"integrity"},
    "bench/scored_run.py": {"repair"},
    "c4s/bundle/writing.py": {"overview", "physics"},
    "c4s/judge/model/judging.py": {"overview"},
    "c4s/judge/model/sights.py": {"overview"},
    "c4s/records/captures.py": {"overview"},
    "c4s/records/migration.py": {"detailed", "overview", "physics"},
    "c4s/records/policy.py": {"overview"},
    "c4s/run/drive.py": {"integrity"},
    "c4s/run/limits.py": {"integrity"},
    "c4s/run/part.py": {"integrity"},
    "c4s/run/repeats.py": {"integrity"},
    "c4s/run/trial.py": {"integrity"},
    "cases/judge_check/probes.py": {"overview"},
    "c4s/score/batch.py": {"detailed", "overview", "physics"},
    "flows/trial.py": {"integrity"},
}
"""Not verifiers: the stage ``integrity``; a target's operation; keys of the published bundle, of a policy file, of a
judgement, of a score of 0.1.0 and of the published rows; the purpose of a view."""

BACKENDS: dict[str, set[str]] = {
    "bench/attacks/trial.py": {"c4s.engine.headless.host.session"},
    "bench/published_walk.py": {"c4s.engine.headless.process.boot", "c4s.engine.headless.world.documents"},
    "bench/blender_view.py": {
        "c4s.engine.headless.pictures.take",
        "c4s.engine.headless.process.boot",
        "c4s.engine.headless.world.state",
    },
    "bench/mask_truth.py": {
        "c4s.engine.headless.pictures.take",
        "c4s.engine.headless.process.boot",
        "c4s.engine.headless.world.state",
    },
    "bench/looks.py": {"c4s.engine.headless.pictures", "c4s.engine.headless.process.boot"},
    "bench/pictures.py": {
        "c4s.engine.headless.pictures",
        "c4s.engine.headless.process.boot",
        "c4s.engine.headless.world.state",
    },
    "bench/rival_pictures.py": {
        "c4s.engine.headless.pictures",
        "c4s.engine.headless.process.boot",
        "c4s.engine.headless.world.state",
    },
    "bench/queries.py": {"c4s.engine.headless.process.boot", "c4s.engine.headless.world"},
    "bench/session.py": {"c4s.engine.headless.host.session"},
}
"""Benchmarks that measure the inside of one engine."""

REMOVALS: dict[str, set[str]] = {"c4s/engine/confine/leftovers.py": {"rmdir"}, "c4s/run/lease.py": {"rmdir"}}
"""Empty folders: of a tree too deep to be removed by paths, and of a run that another process may just have begun."""

PRINTS: dict[str, set[str]] = {"c4s/cli/batches.py": {"sys.stdout.write"}}
"""JSON lines, as they come; their characters are ASCII."""

FILES: dict[str, set[str]] = {
    "cases/starter/outdoor_texts.py": {"whole"},
    "tests/agent_clients/scripted_endpoint.py": {"whole"},
    "tests/catalog/test_collision_bodies.py": {"whole"},
    "tests/engine/test_engine_agent_scripts.py": {"whole"},
    "tests/score/test_scoring_edges.py": {"whole"},
}
"""Data (texts, places, families of things), layout rules, one endpoint that speaks four wire formats, and tables of
cases: one subject each."""
