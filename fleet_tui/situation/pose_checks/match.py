"""Match of a laser scan with the map at a pose: the sign of a robot that is where it believes to be."""

import numpy as np
from msgspec import Struct

from fleet_tui.model.geometry import Pose
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.set_up.streams import Points, placed
from fleet_tui.situation.pose_checks.distance_field import distance_field
from fleet_tui.text.language import Message
from fleet_tui.text.units import percent

NEAR = 0.2
"""Metres to an occupied cell within which a beam fits the map."""
POOR = 0.4
"""Share of fitting beams below which a robot is probably elsewhere."""
DOUBTFUL = 0.75
"""Share below which even a good fit is often at a wrong place."""
FEWEST = 20
"""Beams below which a scan proves nothing."""


class Match(Struct, frozen=True):
    """Share of the beams that end near an occupied cell, and the median distance to one in metres. `beams` is
    their number."""

    share: float
    median: float
    beams: int

    @property
    def is_poor(self) -> bool:
        """Tell whether the robot is probably not at the pose."""
        return self.beams >= FEWEST and self.share < POOR

    @property
    def text(self) -> Message:
        """Return the match in words."""
        return Message(
            "{percent} of {beams} beams fit the map, median {median} m",
            percent=percent(self.share),
            beams=self.beams,
            median=f"{self.median:.2f}",
        )


def match(grid: OccupancyGrid, points: Points, pose: Pose) -> Match | None:
    """Return the match of the ends of the beams, in the robot's frame, for a robot at a pose; None without
    beams."""
    if not len(points):
        return None
    distances = distance_field(grid).at(placed(points, pose))
    near = float(np.count_nonzero(distances <= NEAR + 1e-6)) / len(points)
    return Match(near, float(np.median(distances)), len(points))
