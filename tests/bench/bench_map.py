"""P1: time of a full map frame; P2: walls lost. Run: python -m tests.bench.bench_map"""

import random
import statistics
import time
from collections.abc import Callable

import numpy as np

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid
from fleet_tui.ui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.ground.raster import ground
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene, SceneRobot
from fleet_tui.ui.view.roles import WALLS, StyleRole
from tests.bench.others import others
from tests.bench.rows import Row, row

WIDTH, HEIGHT = 200, 60
SIDE = 4000
ZOOMS = (1.0, 2.0, 4.0, 8.0, 16.0, 40.0, 130.0)


def warehouse(side: int = SIDE) -> OccupancyGrid:
    """A synthetic hall of racks: walls one pixel thick, unknown ground around it."""
    classes = np.full((side, side), FREE, np.uint8)
    rim = side // 40
    classes[:rim] = classes[-rim:] = UNKNOWN
    classes[:, :rim] = classes[:, -rim:] = UNKNOWN
    classes[rim, rim:-rim] = classes[-rim - 1, rim:-rim] = OCCUPIED
    classes[rim:-rim, rim] = classes[rim:-rim, -rim - 1] = OCCUPIED
    aisle = (np.arange(side) // (side // 10)) % 2 == 0
    for top in range(2 * rim, side - 2 * rim, 80):
        rack = classes[top : top + 24, 2 * rim : side - 2 * rim]
        rack[:, aisle[2 * rim : side - 2 * rim]] = OCCUPIED
    return build_grid(MapFrame(0.05, side, side), classes)


def per_dot(grid: OccupancyGrid, camera: Camera) -> list[str]:
    """The plain way: every dot looked up in the full map, in Python."""
    level = grid.levels[0]
    bits = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
    left, top = camera.origin
    height, width = level.shape
    rows = []
    for y in range(camera.height):
        cells = []
        for x in range(camera.width):
            code = 0x2800
            for dot_y in range(DOTS_Y):
                row = int(((top + y) * DOTS_Y + dot_y) * camera.scale)
                for dot_x in range(DOTS_X):
                    column = int(((left + x) * DOTS_X + dot_x) * camera.scale)
                    if 0 <= row < height and 0 <= column < width and level[row, column] == OCCUPIED:
                        code |= bits[dot_y][dot_x]
            cells.append(chr(code))
        rows.append("".join(cells))
    return rows


def median_ms(work: Callable[[], object], times: int) -> float:
    spent = []
    for _ in range(times):
        start = time.perf_counter()
        work()
        spent.append(time.perf_counter() - start)
    return statistics.median(spent) * 1000


def frame_times(grid: OccupancyGrid) -> list[Row]:
    """Our worst frame, and beside it the whole map drawn by others."""
    fit = Camera.fit((SIDE, SIDE), WIDTH, HEIGHT)
    worst = 0.0
    for zoom in ZOOMS:
        camera = fit.zoomed(zoom, (SIDE * 0.3, SIDE * 0.4))
        times = [
            median_ms(lambda c=camera, d=drawing: ground(grid, c, d).all_runs(), 41)  # type: ignore[misc]  # defaults bind the loop's values
            for drawing in Drawing
        ]
        worst = max(worst, *times)
        shown = "  ".join(f"{d.value} {ms:.2f}" for d, ms in zip(Drawing, times, strict=True))
        print(f"    {camera.scale:7.3f} px/dot: {shown} ms")
    plain = median_ms(lambda: per_dot(grid, fit), 7)
    what = f"map frame, {SIDE} x {SIDE}, worst zoom and drawing"
    rows = [
        row("P1", what, worst, "ms", 2.0, plain, "pure Python per dot"),
        row("P1", "map frame, times that of pure Python per dot", worst / plain, "x", 1 / 15),
    ]
    for name, draw in others(grid.levels[0], WIDTH, HEIGHT):
        rows.append(row("P1", what, worst, "ms", None, median_ms(draw, 9), name))
    return rows


def tick_times(grid: OccupancyGrid) -> None:
    """The moving parts over a backdrop that stands: to read beside P3."""
    rng = random.Random(1)
    camera = Camera.fit((SIDE, SIDE), WIDTH, HEIGHT)
    for count in (1, 10, 100, 1000):
        robots = tuple(
            SceneRobot(f"r{n}", n + 1, Pose(rng.uniform(10, 190), rng.uniform(10, 190), rng.uniform(0, 6)))
            for n in range(count)
        )
        scene = Scene("floor_0", grid.frame, grid, robots=robots)
        behind = backdrop(scene, camera, MapOptions())
        ms = median_ms(lambda b=behind, s=scene: picture(b, s, camera, MapOptions()), 41)  # type: ignore[misc]  # as above
        print(f"    robots over the backdrop: {count:4} robots {ms:.2f} ms")


def walls_lost(cases: int = 3300) -> tuple[int, int]:
    """The number of one-pixel walls, at random zooms and offsets, that are not drawn within a dot. Their ends
    may be shorter."""
    rng = random.Random(7)
    lost = total = 0
    while total < cases:
        side = rng.randrange(60, 700)
        classes = np.full((side, side), FREE, np.uint8)
        column = rng.randrange(side)
        classes[:, column] = OCCUPIED
        grid = build_grid(MapFrame(0.05, side, side), classes)
        camera = Camera.fit((side, side), 40, 12).zoomed(2 ** rng.uniform(-1, 5), (column, side / 2))
        camera = camera.panned(rng.randrange(-3, 4), rng.randrange(-3, 4))
        near = {camera.to_cell(column + 0.5 + dot * camera.scale, 0)[0] for dot in (-1, 0, 1)}
        if not all(0 <= x < camera.width for x in near):
            continue
        for drawing in Drawing:
            total += 1
            roles = ground(grid, camera, drawing).roles
            walls = np.isin(roles, WALLS)
            inside = (walls | (roles == StyleRole.FLOOR)).any(axis=1)
            lost += not walls[inside][1:-1, sorted(near)].any(axis=1).all()
    return lost, total


def main() -> list[Row]:
    grid = warehouse()
    rows = frame_times(grid)
    tick_times(grid)
    lost, total = walls_lost()
    return [*rows, row("P2", f"walls of one pixel lost in {total} cases", lost, "walls", 0)]


if __name__ == "__main__":
    main()
