"""Things all over a rectangle: in a grid, or by chance."""

from __future__ import annotations

from collections.abc import Sequence

from cases.open190.layout.putting import Putting
from cases.open190.layout.things import Assets, Item, Pair


class Filling(Putting):
    """Stands things all over rectangles."""

    def grid(
        self,
        box: tuple[float, float, float, float],
        assets: Assets,
        columns: int,
        rows_: int,
        *,
        yaw: float = 0.0,
        z: float = 0.0,
        jitter: float = 0.0,
    ) -> list[Item]:
        """Things at the crossings of columns and rows in a rectangle (x0, y0, x1, y1)."""
        x0, y0, x1, y1 = box
        found = []
        for j in range(rows_):
            for i in range(columns):
                x = x0 + (x1 - x0) * (i / (columns - 1) if columns > 1 else 0.5)
                y = y0 + (y1 - y0) * (j / (rows_ - 1) if rows_ > 1 else 0.5)
                item = self.put(
                    assets,
                    x + self.uni(-jitter, jitter),
                    y + self.uni(-jitter, jitter),
                    z,
                    yaw + self.uni(-jitter, jitter) * 0.3,
                )
                self.relate("in_grid", item)
                if item:
                    found.append(item)
        return found

    def scatter(
        self,
        box: tuple[float, float, float, float],
        assets: Assets,
        count: int,
        *,
        clear: float = 20.0,
        scale: Pair = (0.9, 1.1),
        z: float = 0.0,
        avoid: Sequence[tuple[float, float, float, float]] = (),
    ) -> list[Item]:
        """Things at random places of a rectangle, at least ``clear`` cm from others and outside ``avoid``."""
        x0, y0, x1, y1 = box
        found: list[Item] = []
        for _ in range(count):
            asset = self.choose(assets)
            for _attempt in range(8):
                x, y = self.uni(x0, x1), self.uni(y0, y1)
                if any(a <= x <= c and b <= y <= d for a, b, c, d in avoid):
                    continue
                before = self.left_out[asset]
                item = self.put(asset, x, y, z, self.uni(-180, 180), scale=self.uni(*scale), margin=clear)
                self.left_out[asset] = before
                if item is not None:
                    self.relate("scattered", item)
                    found.append(item)
                    break
            else:
                self.left_out[asset] += 1
        return found
