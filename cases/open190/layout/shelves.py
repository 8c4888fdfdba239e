"""Things on another: on a table, in a shelf, in a stack."""

from __future__ import annotations

from c4s.geometry.transform import normalize_axis
from cases.open190.layout.putting import Putting
from cases.open190.layout.things import TOP_CM, Assets, Item
from catalog.kits.maker import StandingSurface

GAP_CM = 0.2
"""Air under what stands on something: rounding never makes it sink."""


class Shelving(Putting):
    """Stands things on the surfaces of others."""

    def on(
        self, item: Item | None, assets: Assets, count: int = 1, *, surface: int = -1, yaw: float | None = None
    ) -> list[Item]:
        """Stand things on a surface of another (the topmost one unless told) where there is room."""
        if item is None or not item.thing.surfaces:
            return []
        found: list[Item] = []
        top = item.thing.surfaces[surface]
        for _ in range(count):
            asset = self.choose(assets)
            for _attempt in range(8):
                turn = self.uni(-25, 25) if yaw is None else yaw
                made = self._on(item, top, asset, self.uni(-0.5, 0.5), self.uni(-0.5, 0.5), turn)
                if made is not None:
                    found.append(made)
                    break
        return found

    def _on(self, item: Item, top: StandingSurface, asset: str, u: float, v: float, turn: float) -> Item | None:
        thing = self.thing(asset)
        spare_x, spare_y = top.width - thing.width, top.depth - thing.depth
        if self.tops_only and item.thing.high[2] - top.z > TOP_CM:
            return None
        if spare_x < 0 or spare_y < 0 or thing.high[2] - thing.low[2] > top.room:
            return None
        x, y = item.at(top.x + u * spare_x, top.y + v * spare_y)
        before = self.left_out[asset]
        made = self._put(
            asset,
            round(x, 3),
            round(y, 3),
            round(normalize_axis(item.yaw + turn), 3),
            item.z + top.z * item.scale[2] + GAP_CM,
            1.0,
            0.1,
            0.0,
        )
        self.left_out[asset] = before
        self.relate("on", made, item)
        return made

    def middle(self, item: Item | None, assets: Assets, *, surface: int = -1, yaw: float = 0.0) -> Item | None:
        """Stand one thing on the middle of a surface."""
        if item is None or not item.thing.surfaces:
            return None
        return self._on(item, item.thing.surfaces[surface], self.choose(assets), 0.0, 0.0, yaw)

    def stock(self, item: Item | None, assets: Assets, gap: float = 4.0, share: float = 0.9) -> int:
        """Fill every surface of a shelf with things side by side; returns how many."""
        if item is None:
            return 0
        count = 0
        for top in item.thing.surfaces:
            x = -top.width / 2
            while True:
                thing = self.thing(self.choose(assets))
                if x + thing.width > top.width / 2:
                    break
                if self.random.random() < share and thing.high[2] - thing.low[2] <= top.room:
                    spare = top.width - thing.width
                    u = (x + thing.width / 2) / spare if spare > 1 else 0.0
                    count += (
                        self._on(item, top, thing.name, max(-0.5, min(0.5, u)), self.uni(-0.2, 0.2), 0.0) is not None
                    )
                x += thing.width + gap
        return count

    def stack(self, assets: Assets, x: float, y: float, levels: int, yaw: float = 0.0) -> Item | None:
        """Things on top of each other."""
        base = item = self.put(assets, x, y, yaw=yaw)
        for _ in range(levels - 1):
            item = self.middle(item, assets, yaw=self.uni(-8, 8)) if item else None
        return base
