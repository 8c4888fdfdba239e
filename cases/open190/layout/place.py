"""A place under construction, with all rules."""

from __future__ import annotations

from c4s.records.level import Level, Vector
from cases.corruption import with_identities
from cases.model import CaseView
from cases.open190.layout.fields import Filling
from cases.open190.layout.lights import Lighting
from cases.open190.layout.lines import Lining
from cases.open190.layout.rooms import Walling
from cases.open190.layout.shelves import Shelving
from cases.open190.layout.tables import Seating


class StagedPlace(Shelving, Seating, Lining, Filling, Walling, Lighting):
    """A scene under construction."""

    def view(self, name: str, eye: Vector, target: Vector, fov: float = 70.0) -> None:
        """A camera of this place."""
        self.views.append(CaseView(name, eye, target, fov))

    def level(self) -> Level:
        """The finished level, with a stable-id tag on every actor."""
        return with_identities(Level(package=f"/Game/C4SScenes/{self.scene_id}", actors=self.actors), self.scene_id)
