"""The match of a scan with the map: near one at the true pose, poor elsewhere."""

import numpy as np

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.model.set_up.streams import LaserScan, beams_of
from fleet_tui.simulator.floorplan import HEIGHT, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.senses.laser import BEAMS, ranges
from fleet_tui.situation.pose_checks.match import Match, match
from tests.support.navigating import FLOOR

GRID = grid_from_ros(MapFrame(RESOLUTION, WIDTH, HEIGHT, Pose(*ORIGIN)), FLOOR.cells.tobytes())
TRUE = Pose(8.0, 0.0, 0.4)
STEP = 2 * np.pi / BEAMS
POINTS = beams_of(LaserScan(ranges(FLOOR.cells, TRUE), -np.pi, STEP, 0.1, 12.0, "laser", None), None).points


def test_the_true_pose_fits() -> None:
    found = match(GRID, POINTS, TRUE)
    assert found is not None and found.share > 0.99 and found.median < 0.05 and not found.is_poor


def test_elsewhere_is_poor_and_says_so() -> None:
    found = match(GRID, POINTS, TRUE.after(Pose(3.0, 2.5, 0.7)))
    assert found is not None and found.is_poor
    assert found.text.endswith(" m") and " beams fit the map, median " in found.text
    assert found.text.startswith(f"{found.share * 100:.0f} % of ")


def test_a_small_turn_is_seen() -> None:
    near, off = (match(GRID, POINTS, TRUE.after(Pose(0.0, 0.0, turn))) for turn in (0.02, 0.2))
    assert near is not None and off is not None and near.share > off.share


def test_few_beams_prove_nothing() -> None:
    assert match(GRID, POINTS[:0], TRUE) is None
    assert not Match(0.0, 2.0, 5).is_poor
    lost = match(GRID, POINTS, Pose(np.nan, 0.0))
    assert lost is not None and lost.share == 0.0
