"""What the stages of a trial read: its case, as it was frozen, and the evidence that lies in a folder."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from c4s.packs.suite_check import check_case
from c4s.records.evidence import Evidence, EvidenceName, ManifestDigests
from c4s.records.folder import EvidenceFolder
from c4s.records.level import Level
from c4s.records.suite import AgentCase, SuiteFolder, WithheldCase, WithheldFolder
from c4s.run.grounds import check_grounds
from c4s.run.plan import Trial


@dataclass(frozen=True)
class TrialInputs:
    """What the stages of a trial read of its suite."""

    case: AgentCase
    withheld: WithheldCase
    agent_folder: Path
    withheld_folder: WithheldFolder
    packs: list[Path]


def inputs(trial: Trial) -> TrialInputs:
    """Open the case package; ``BadInput`` where it or one of its packs is not as the plan froze it, or unsound."""
    suite = SuiteFolder(trial.suite)
    case, folders = check_case(suite, trial.case)
    withheld = WithheldFolder(suite.withheld(trial.case.case_id))
    check_grounds(withheld, folders)
    return TrialInputs(
        case=case,
        withheld=suite.withheld_case(trial.case.case_id),
        packs=folders,
        agent_folder=suite.agent(case.alias),
        withheld_folder=withheld,
    )


def offered(case: AgentCase, agent_folder: Path) -> list[str]:
    """The meshes and Blueprints that are there for a case, by path: its catalog, and what its start level shows."""
    return sorted({*case.catalog, *Level.read(agent_folder / "start.level.json").made_of()})


def evidence_in(
    exported: EvidenceFolder,
    given: TrialInputs,
    judgements: Path,
    noted: Mapping[str, str] | None = None,
    manifest: ManifestDigests | None = None,
) -> Evidence:
    """What was exported into a folder, beside the files of its case.

    ``noted`` are the digests of the exported files by relative name, where they were kept: any other is refused.
    """
    withheld = given.withheld_folder
    made: dict[EvidenceName, Path] = {
        "candidate_snapshot": exported.snapshot,
        "dependencies": exported.dependencies,
        "captures": exported.captures_index,
        "contacts": exported.contacts,
        "support": exported.support,
        "navigation": exported.navigation,
    }
    return Evidence(
        setting=given.case.setting,
        prompt=given.case.prompt,
        files={
            **made,
            "input_snapshot": withheld.input_snapshot,
            "truth_snapshot": withheld.truth_snapshot,
            "requirements": withheld.requirements,
            "binding": withheld.binding,
            "judgements": judgements,
        },
        noted={}
        if noted is None
        else {name: noted.get(path.relative_to(exported.root).as_posix(), "") for name, path in made.items()},
        noted_files=None if noted is None else {exported.root / name: sha256 for name, sha256 in noted.items()},
        packs=given.packs,
        minimum_actors=given.withheld.minimum_actors,
        manifest=manifest,
    )
