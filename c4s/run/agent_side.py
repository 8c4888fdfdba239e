"""The agent's side of a case alone: its folder and its packs, on a machine that need not have the withheld tree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.agents.base import Agent
from c4s.errors import BadInput
from c4s.folders import check_new, remove_tree
from c4s.home import packs_root
from c4s.packs.check import check_pack
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder
from c4s.records.plan import Configuration
from c4s.records.suite import AgentCase, SuiteFolder
from c4s.run.aside import set_aside
from c4s.run.attempt import run_attempt
from c4s.trees import listing_digest, read_listing

CASE = "case.json"


@dataclass(frozen=True)
class AgentSide:
    """What an attempt at a case needs, and nothing that an agent may not see."""

    case: AgentCase
    folder: Path
    packs: Sequence[Path]

    @classmethod
    def of_folder(cls, folder: Path) -> AgentSide:
        """A case by the agent's folder of it. ``BadInput`` where it or one of its packs cannot be used."""
        if not (folder / CASE).is_file():
            raise BadInput("this is no agent's folder of a case", where=str(folder), todo=f"it must hold {CASE}")
        case = AgentCase.read(folder / CASE)
        packs = [packs_root() / reference.pack_id for reference in case.packs]
        for place, reference in zip(packs, case.packs, strict=True):
            if not place.is_dir():
                raise BadInput(
                    f"pack {reference.pack_id!r} is missing",
                    where=case.alias,
                    todo=f"build it into {packs_root()} with `c4s catalog build`",
                )
            check_pack(place, reference.digest)
        return cls(case, folder, packs)

    @classmethod
    def of_suite(cls, suite: SuiteFolder, case_id: str) -> AgentSide:
        """A case of a built suite. ``BadInput`` too where its agent's folder is not as it was frozen."""
        frozen = suite.case(case_id)
        side = cls.of_folder(suite.agent(frozen.alias))
        if listing_digest(read_listing(side.folder)) != frozen.agent_digest:
            raise BadInput(
                "these are not the files that were frozen",
                where=str(side.folder),
                todo=f"`c4s suite check {suite.root.name}` lists every file; restore it, or build with --replace",
            )
        return side

    def attempt(
        self,
        configuration: Configuration,
        out: Path,
        *,
        engine: str,
        agent: Agent | None = None,
        withheld: Path | None = None,
    ) -> AttemptOutcome:
        """One attempt, kept in a new folder. One that is there is set aside where no call was made in it.

        ``withheld``: for the oracle alone, a folder with the truth.
        """
        kept = AttemptFolder(out)
        if kept.done and AttemptOutcome.read(kept.outcome).tool_calls == 0:
            set_aside(out)
        check_new(out)
        remove_tree(out, inside=out.absolute().parent)
        return run_attempt(
            self.case,
            self.folder.absolute(),
            configuration,
            1,
            out.absolute(),
            self.packs,
            withheld,
            engine=engine,
            agent=agent,
        )
