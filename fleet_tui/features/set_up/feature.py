from functools import partial

from fleet_tui.features.set_up.mapping import MappingControls
from fleet_tui.features.set_up.poses import PoseRequests
from fleet_tui.features.set_up.snap import PoseSnap
from fleet_tui.keys.place import FINE_TURN, TURN
from fleet_tui.ui.controllers.comparison import ScanComparison
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.screens.feature import Feature
from fleet_tui.ui.view.map.map_picture import MapPicture


class SetUp:
    """Poses, goals and mapping."""

    def __init__(
        self, console: Console, controls: MapControls, picture: MapPicture, comparison: ScanComparison
    ) -> None:
        self.poses = PoseRequests(console, controls, picture, comparison)
        self.snap = PoseSnap(console, controls, picture)
        self.mapping = MappingControls(console, picture)
        self.feature = Feature(
            actions={
                "pose": self.poses.pose,
                "goal": self.poses.goal,
                "place_send": self.poses.send,
                "place_left": partial(self.poses.turn, TURN),
                "place_right": partial(self.poses.turn, -TURN),
                "place_fine_left": partial(self.poses.turn, FINE_TURN),
                "place_fine_right": partial(self.poses.turn, -FINE_TURN),
                "place_snap": self.snap.snap,
                "place_leave": self.poses.leave,
                "mapping": self.mapping.menu,
            },
            typed=(self.mapping.typed,),
        )
