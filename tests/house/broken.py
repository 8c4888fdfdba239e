"""The files that break a house rule today, and with what. A list grows shorter, never longer."""

from __future__ import annotations

RUN_FILES: dict[str, set[str]] = {
    "bench/attacks.py": {"trajectory.jsonl"},
    "bench/gateway.py": {"trajectory.jsonl"},
    "bench/scored_run.py": {"verdicts"},
    "bench/session.py": {"trajectory.jsonl"},
    "c4s/run/attempt.py": {
        "manifest.json",
        "outcome.json",
        "saves.jsonl",
        "submission",
        "trajectory.jsonl",
        "usage.jsonl",
    },
    "c4s/agents/replay.py": {"trajectory.jsonl"},
    "c4s/bundle/writing.py": {"outcome.json", "snapshot.json"},
    "c4s/cli/agent.py": {"outcome.json", "plan.json", "trajectory.jsonl"},
    "c4s/cli/bundle.py": {"plan.json"},
    "c4s/cli/live.py": {"trajectory.jsonl", "usage.jsonl"},
    "c4s/cli/report.py": {"plan.json"},
    "c4s/evidence/collect.py": {"captures.json", "dependencies.json", "digests.json", "evidence", "snapshot.json"},
    "c4s/engine/headless/world/world.py": {"saves.jsonl"},
    "c4s/run/stages.py": {
        "captures.json",
        "dependencies.json",
        "integrity.json",
        "manifest.json",
        "outcome.json",
        "snapshot.json",
        "spending.jsonl",
        "stages.jsonl",
        "submission",
    },
    "cases/exports.py": {"snapshot.json"},
    "cases/generate.py": {"snapshot.json"},
    "warehouse/ingest.py": {
        "captures.json",
        "integrity.json",
        "outcome.json",
        "plan.json",
        "stages.jsonl",
        "trajectory.jsonl",
        "verdicts",
    },
}
"""Files and folders of a run folder, spelt outside the records."""

SETTINGS: dict[str, set[str]] = {
    "bench/gateway.py": {"text-to-scene"},
    "bench/scored_run.py": {"text-to-scene"},
    "bench/session.py": {"image-to-scene/outdoor"},
    "c4s/agents/baselines/planner.py": {"text-to-scene"},
    "c4s/agents/baselines/random.py": {"text-to-scene"},
    "c4s/bundle/manifest.py": {"text-to-scene"},
    "c4s/bundle/scoring.py": {"text-to-scene"},
    "c4s/bundle/writing.py": {"image-to-scene", "text-to-scene"},
    "c4s/records/suite.py": {"image-to-scene/indoor", "image-to-scene/outdoor", "text-to-scene"},
    "c4s/cli/verify.py": {"image-to-scene", "text-to-scene"},
    "c4s/run/stages.py": {"text-to-scene"},
    "c4s/score/aggregate.py": {"image-to-scene", "image-to-scene/indoor", "image-to-scene/outdoor", "text-to-scene"},
    "c4s/score/case.py": {"text-to-scene"},
    "c4s/score/policies.py": {"text-to-scene"},
    "c4s/protocol/rules.py": {"image-to-scene", "image-to-scene/indoor", "image-to-scene/outdoor", "text-to-scene"},
    "c4s/score/rescore.py": {"text-to-scene"},
    "c4s/toolbox/measured.py": {"text-to-scene"},
    "c4s/verify/physics/verdict.py": {"image-to-scene", "text-to-scene"},
    "flows/evaluate.py": {"text-to-scene"},
    "reports/site.py": {"image-to-scene/indoor", "image-to-scene/outdoor", "text-to-scene"},
    "reports/templates/agent.html.j2": {"text-to-scene"},
    "reports/templates/case.html.j2": {"text-to-scene"},
    "warehouse/sql/leaderboard.sql": {
        "image-to-scene",
        "image-to-scene/indoor",
        "image-to-scene/outdoor",
        "text-to-scene",
    },
    "warehouse/sql/sanity_ladder.sql": {"text-to-scene"},
}
"""Settings, spelt outside the protocol and the registry of verifiers."""

VERIFIERS: dict[str, set[str]] = {
    "bench/scored_run.py": {"detailed", "integrity", "overview", "physics", "repair"},
    "c4s/bundle/scoring.py": {"detailed", "integrity", "overview", "physics", "repair"},
    "c4s/bundle/writing.py": {"detailed", "integrity", "overview", "physics"},
    "c4s/cli/agent.py": {"detailed", "overview", "physics"},
    "c4s/cli/bundle.py": {"detailed", "overview", "physics"},
    "c4s/run/stages.py": {"detailed", "integrity", "overview", "physics", "repair"},
    "c4s/run/trial.py": {"physics", "repair"},
    "c4s/score/aggregate.py": {"physics"},
    "c4s/score/batch.py": {"detailed", "overview", "physics"},
    "c4s/score/case.py": {"detailed", "integrity", "overview", "physics", "repair"},
    "c4s/score/policies.py": {"detailed", "overview", "physics"},
    "c4s/protocol/rules.py": {"detailed", "overview", "physics"},
    "c4s/score/rescore.py": {"detailed", "integrity", "overview", "physics", "repair"},
    "c4s/toolbox/measured.py": {"physics"},
    "flows/evaluate.py": {"detailed", "overview"},
    "warehouse/findings.py": {"detailed", "physics", "repair"},
    "warehouse/ingest.py": {"detailed", "overview", "physics"},
}
"""Verifiers, spelt outside ``c4s/verify`` and the protocol."""

BACKENDS: dict[str, set[str]] = {
    "bench/pictures.py": {"c4s.engine.headless"},
    "bench/queries.py": {"c4s.engine.headless"},
    "c4s/cli/engine.py": {
        "c4s.engine.headless.process.boot",
        "c4s.engine.headless.glb.level",
        "c4s.engine.headless.world.documents",
        "c4s.engine.headless.world.state",
    },
    "c4s/engine/headless/host/kernels.py": {"c4s.render.compiled", "c4s.engine.headless.pictures.take"},
    "c4s/engine/headless/host/session.py": {
        "c4s.engine.headless.host.jobs",
        "c4s.engine.headless.process.main",
        "c4s.engine.headless.host.server",
    },
    "catalog/preview.py": {"c4s.engine.headless"},
}
"""Modules of a backend, imported outside ``open_engine``."""

FUNCTIONS: dict[str, set[str]] = {
    "c4s/run/attempt.py": {"run_attempt"},
    "c4s/agents/clients/claude_code.py": {"command"},
    "c4s/agents/clients/opencode.py": {"command"},
    "c4s/render/kernels.py": {"_next_layer"},
    "c4s/render/renderer.py": {"render"},
    "c4s/render/shade.py": {"_add_local"},
    "c4s/render/tables.py": {"_assemble"},
    "c4s/engine/headless/unreal/core/checks.py": {"api"},
    "c4s/engine/confine/sandbox.py": {"start"},
    "c4s/engine/headless/host/session.py": {"start"},
    "c4s/protocol/physics.py": {"physics_from_report"},
    "c4s/protocol/requirements.py": {"semantic_case"},
    "c4s/verify/semantic/detailed.py": {"verify_detailed"},
    "c4s/verify/integrity/verdict.py": {"verify_integrity"},
    "c4s/verify/physics/verdict.py": {"verify_physics"},
    "c4s/verify/repair/advisories.py": {"advisories"},
    "cases/importers/scene.py": {"write_scene"},
    "cases/requirements.py": {"bundle"},
    "cases/starter/outdoor_texts.py": {"farm_text", "harbour_text"},
    "catalog/ingest/folder.py": {"_built"},
    "tests/agent_clients/matrix.py": {"drive"},
    "tests/cases/test_scene_formats.py": {"test_a_gltf_tree_brings_names_instances_lights_and_cameras"},
    "tests/warehouse/test_leaderboard_sql.py": {"_store"},
}
"""Functions of more than 60 lines."""

FILES: dict[str, set[str]] = {
    "c4s/verify/physics/verdict.py": {"whole"},
    "cases/starter/outdoor_texts.py": {"whole"},
    "tests/agent_clients/scripted_endpoint.py": {"whole"},
    "tests/catalog/test_collision_bodies.py": {"whole"},
    "tests/engine/test_engine_agent_scripts.py": {"whole"},
    "tests/score/test_scoring_edges.py": {"whole"},
}
"""Files of more than 400 lines."""

CLASSES: dict[str, set[str]] = {
    "Answer": {"c4s/toolbox/run.py", "c4s/trajectory/feedback.py"},
    "Entity": {"c4s/protocol/bundle.py", "cases/requirements.py"},
    "Entry": {"c4s/planner/place.py", "c4s/toolbox/catalog.py", "c4s/verify/actors/entries.py"},
    "Finding": {"c4s/cli/doctor.py", "warehouse/findings.py"},
    "Job": {"c4s/engine/headless/host/jobs.py", "c4s/toolbox/workbench.py"},
    "Part": {"c4s/editor/facts.py", "c4s/judge/rule/overview.py", "catalog/shapes/spec.py"},
    "Paths": {"c4s/editor/facts.py", "c4s/engine/confine/sandbox.py"},
    "Picture": {"c4s/render/textures.py", "c4s/render/types.py"},
    "Predicate": {"c4s/protocol/bundle.py", "cases/requirements.py"},
    "Record": {"c4s/records/base.py", "c4s/toolbox/record.py"},
    "Row": {"bench/row.py", "catalog/ingest/listing.py"},
    "Run": {"c4s/bundle/manifest.py", "c4s/toolbox/run.py"},
    "Scene": {"c4s/engine/headless/pictures/take.py", "c4s/verify/repair/actors.py", "cases/model.py"},
    "Shape": {"c4s/collision/shapes.py", "catalog/shapes/builder.py"},
    "Target": {"c4s/engine/headless/queries/index.py", "c4s/verify/repair/targets.py"},
    "Task": {"c4s/bundle/manifest.py", "cases/code4scene/tasks.py"},
    "Thing": {"c4s/semantics/inventory.py", "c4s/toolbox/search/net.py", "cases/generate.py"},
    "View": {"c4s/render/packets.py", "cases/model.py"},
}
"""Names that more than one public class has."""
