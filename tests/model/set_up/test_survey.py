"""Facts of a map."""

import numpy as np

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import build_grid
from fleet_tui.model.set_up.survey import survey


def test_areas_are_those_of_the_classes() -> None:
    cells = np.array([[0, 1, 1, 2], [0, 0, 1, 2]], np.uint8)
    found = survey(build_grid(MapFrame(0.5, 4, 2, Pose(1.0, 2.0, 0.1)), cells))
    assert (found.free, found.occupied, found.known, found.size) == (0.75, 0.5, 1.25, (2.0, 1.0))
    assert found.origin == (1.0, 2.0, 0.1)
    assert found.text == "2.0 x 1.0 m, 4 x 2 cells of 0.5 m, 1 m2 known"
