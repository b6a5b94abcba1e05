"""P4: bytes to the terminal per tick of the map, against stock Textual in the same run.

Run: python -m tests.bench.bench_bytes
"""

import asyncio
import math
import os
import random
import time
from dataclasses import replace
from unittest.mock import patch

import numpy as np
from textual.app import ComposeResult

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.widgets.map_view import MapView
from tests.bench.rows import Row, row
from tests.support.terminal import PlayedDriver, paint, terminal_of

WIDTH, HEIGHT = 200, 61  # 60 rows of map below the caption
HALL = (48.0, 28.0)  # metres: a cell is 0.24 x 0.48 m, small enough to change often
SPEED, TICK = 1.2, 0.1  # metres per second, seconds
TICKS = 200
TARGETS = {1: 150, 10: 800, 100: 6000}


class CountingDriver(PlayedDriver):
    """Keeps what is written without looking at it."""

    def write(self, data: str) -> None:
        self.written.append(data)


class MapAlone(LeanApp):
    CSS = "MapView { height: 1fr; }"

    def __init__(self) -> None:
        super().__init__(driver_class=CountingDriver)
        self.map = MapView(load_themes()[0]["dark"].styles())

    def compose(self) -> ComposeResult:
        yield self.map


def hall(robots: int, rng: random.Random) -> Scene:
    """Racks, labelled vertices, and robots anywhere."""
    resolution = 0.05
    width, height = (round(side / resolution) for side in HALL)
    classes = np.full((height, width), FREE, np.uint8)
    classes[0] = classes[-1] = classes[:, 0] = classes[:, -1] = OCCUPIED
    for top in range(60, height - 60, 80):
        classes[top : top + 24, 60:-60:2] = OCCUPIED
    frame = MapFrame(resolution, width, height)
    places = tuple(
        SceneVertex(str(n), rng.uniform(1, HALL[0] - 1), rng.uniform(1, HALL[1] - 1), label=f"Place {n}")
        for n in range(12)
    )
    fleet = tuple(
        SceneRobot(
            f"robot_{n}",
            n + 1,
            Pose(rng.uniform(1, HALL[0] - 1), rng.uniform(1, HALL[1] - 1), rng.uniform(-math.pi, math.pi)),
            selected=n == 0,
        )
        for n in range(robots)
    )
    return Scene("floor_0", frame, build_grid(frame, classes), places, robots=fleet)


def driven(robot: SceneRobot) -> SceneRobot:
    """One tick further; walls turn it round."""
    pose = robot.pose
    x, y = pose.x + SPEED * TICK * math.cos(pose.yaw), pose.y + SPEED * TICK * math.sin(pose.yaw)
    if 0.5 < x < HALL[0] - 0.5 and 0.5 < y < HALL[1] - 0.5:
        return robot._replace(pose=Pose(x, y, pose.yaw))
    return robot._replace(pose=Pose(pose.x, pose.y, pose.yaw + 2.0))


async def per_tick(robots: int, lean: bool) -> tuple[float, float]:
    """Bytes and milliseconds of a tick, from the new scene to the driver: means after the first paint."""
    scene = hall(robots, random.Random(robots))
    spent = 0.0
    with patch.object(MapAlone, "LEAN", lean):
        app = MapAlone()
        async with app.run_test(headless=False, size=(WIDTH, HEIGHT)) as pilot:
            app.map.show(scene)
            await pilot.pause()
            written = terminal_of(app).written
            written.clear()
            for _ in range(TICKS):
                scene = replace(scene, robots=tuple(map(driven, scene.robots)))
                start = time.process_time()
                app.map.show(scene)
                paint(app, app.map)
                spent += time.process_time() - start
    return len("".join(written).encode()) / TICKS, spent / TICKS * 1000


def main() -> list[Row]:
    rows = []
    with patch.dict(os.environ, TERM="xterm-256color", COLORTERM="truecolor"):
        os.environ.pop("NO_COLOR", None)
        for robots, target in TARGETS.items():
            lean, lean_ms = asyncio.run(per_tick(robots, True))
            stock, stock_ms = asyncio.run(per_tick(robots, False))
            what = f"map tick to the terminal, {robots} robot{'s' * (robots > 1)}"
            rows.append(row("P4", what, lean, "bytes", target, stock, "stock Textual"))
            print(f"    {lean_ms:.2f} ms of CPU, stock {stock_ms:.2f}")
    return rows


if __name__ == "__main__":
    main()
