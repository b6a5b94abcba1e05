"""The best match around a pose: the pose of a scan is found again, and nothing worse than the start."""

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED
from fleet_tui.model.occupancy import build_grid
from fleet_tui.model.set_up.streams import Points, placed
from fleet_tui.situation.pose_checks.match import match
from fleet_tui.situation.pose_checks.nearby import REACH, best_near

SIDE = 240
FRAME = MapFrame(0.05, SIDE, SIDE, Pose(-2.0, 1.0, 0.3))
RANGE = 5.0
headings = st.floats(-math.pi, math.pi)


def asymmetric() -> np.ndarray:
    """A hall with a niche, a shelf, a slanting wall and pillars of no order."""
    cells = np.full((SIDE, SIDE), FREE, np.uint8)
    cells[0] = cells[-1] = cells[:, 0] = cells[:, -1] = OCCUPIED
    cells[40:44, 30:110] = cells[90:200, 180:186] = OCCUPIED
    for step in range(60):
        cells[150 + step // 2, 20 + step] = OCCUPIED
    for row, column in np.random.default_rng(5).integers(20, SIDE - 20, (12, 2)):
        cells[row : row + 5, column : column + 5] = OCCUPIED
    return cells


CELLS = asymmetric()
GRID = build_grid(FRAME, CELLS)
WALLS = np.array(
    [FRAME.to_world(column + 0.5, row + 0.5) for row, column in np.argwhere(CELLS == OCCUPIED)], np.float32
)


def scan(pose: Pose) -> Points:
    """The walls within the laser's range, as seen from a pose."""
    seen = WALLS[np.hypot(WALLS[:, 0] - pose.x, WALLS[:, 1] - pose.y) < RANGE]
    return placed(seen - np.array((pose.x, pose.y), np.float32), Pose(0.0, 0.0, -pose.yaw))


@settings(max_examples=settings().max_examples // 4)  # each searches some thousand poses
@given(
    st.floats(60.0, 180.0), st.floats(60.0, 180.0), headings, st.floats(0.0, 0.9 * REACH), headings, headings
)
def test_the_pose_of_a_scan_is_found_again(
    column: float, row: float, yaw: float, away: float, way: float, turned: float
) -> None:
    if CELLS[int(row), int(column)] == OCCUPIED:
        return
    true = Pose(*FRAME.to_world(column, row), yaw)
    points = scan(true)
    start = Pose(true.x + away * math.cos(way), true.y + away * math.sin(way), turned)
    found, at_start = best_near(GRID, points, start), match(GRID, points, start)
    assert at_start is not None
    pose, share = (start, at_start.share) if found is None else (found[0], found[1].share)
    assert share >= 0.98
    assert math.dist((pose.x, pose.y), (true.x, true.y)) < 0.25
    assert abs(math.remainder(pose.yaw - true.yaw, math.tau)) < math.radians(4)


@given(
    st.lists(st.tuples(st.floats(-8.0, 8.0), st.floats(-8.0, 8.0)), min_size=1, max_size=60),
    st.floats(-20.0, 20.0) | st.just(math.nan),
    st.floats(-20.0, 20.0),
    headings,
)
def test_it_is_better_than_the_start_and_near_it(
    ends: list[tuple[float, float]], x: float, y: float, yaw: float
) -> None:
    points, start = np.array(ends, np.float32), Pose(x, y, yaw)
    found, at_start = best_near(GRID, points, start), match(GRID, points, start)
    if found is not None:
        pose, matched = found
        assert at_start is not None and matched == match(GRID, points, pose)
        assert (matched.share, -matched.median) > (at_start.share, -at_start.median)
        assert math.dist((pose.x, pose.y), (x, y)) < REACH + 1.0 and -math.pi <= pose.yaw <= math.pi


def test_at_its_own_pose_there_is_hardly_a_better_one_and_without_beams_none() -> None:
    true = Pose(*FRAME.to_world(120, 120), 1.0)
    found = best_near(GRID, scan(true), true)
    assert found is None or math.dist((found[0].x, found[0].y), (true.x, true.y)) < 0.1
    assert best_near(GRID, scan(true)[:0], true) is None


def test_no_robot_stands_in_a_wall() -> None:
    """Of two places that fit, the nearer one is inside a shelf."""
    cells = np.full((200, 200), FREE, np.uint8)
    cells[50:150, 80:120] = OCCUPIED
    grid = build_grid(MapFrame(0.05, 200, 200), cells)
    found = best_near(grid, np.array([[0.5, 0.0]] * 30, np.float32), Pose(3.2, 5.0))
    assert found is not None and found[1].share == 1.0
    column, row = grid.frame.to_pixel(found[0].x, found[0].y)
    assert cells[int(row), int(column)] == FREE
