"""The robot and the floor selected by the operator."""

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState


class Selection(Struct, frozen=True):
    """`chosen`: the floor stays; until then it becomes the robot's as soon as that is known."""

    robot: str
    floor: str
    chosen: bool = False

    def on_robot(self, name: str) -> "Selection":
        """Select another robot; the map goes to its floor once."""
        return replace(self, robot=name, chosen=self.chosen and name == self.robot)

    def step_robot(self, state: FleetState, step: int) -> "Selection":
        """Select the next or previous robot of the config, around the ends."""
        names = list(state.robots)
        return self.on_robot(names[(names.index(self.robot) + step) % len(names)])

    def step_floor(self, state: FleetState, step: int) -> "Selection":
        """Select the next or previous floor, around the ends."""
        floors = list(state.floors)
        return replace(self, floor=floors[(floors.index(self.floor) + step) % len(floors)], chosen=True)

    def settled(self, state: FleetState, follow: bool) -> "Selection":
        """Return the selection on the robot's floor, while the map follows and once after a selection."""
        actual = state.robots[self.robot].floor
        if actual is None or (self.chosen and not follow):
            return self
        return replace(self, floor=actual, chosen=True)


def first_selection(state: FleetState) -> Selection:
    """Return the first robot of the config and its first possible floor."""
    robot = next(iter(state.robots.values()))
    return Selection(robot.name, next(iter(robot.maps)))
