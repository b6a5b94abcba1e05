"""Simulated lifts and doors: they follow the robots that use them."""

from collections.abc import Mapping

from fleet_tui.simulator.rmf.member import SimMember
from fleet_tui.simulator.warehouse import Building

OPEN_FOR = 4.0
"""Seconds for which a door stays open behind a robot."""
NEAR = 2.0
"""Metres from a door at which it opens for a robot."""
CLOSED = 0
MOVING = 1
OPEN = 2
"""States of a door."""
DOORS = {"ward_door": (10.0, 10.0), "kitchen_door": (23.0, 16.5)}
"""The place of each door, on every floor the same."""
LIFT = "lift_1"
AGV = 2
FIRE = 3
"""Modes of a lift."""
OFFLINE = 3
"""The mode of a door that is out of order."""


class SimLift:
    mode = AGV

    def __init__(self, building: Building) -> None:
        self.floors = [floor.name for floor in building.floors]
        self.floor = self.destination = self.floors[0]
        self.session = ""

    def step(self, members: Mapping[str, SimMember], building: Building) -> None:
        riding = (
            one
            for one in members.values()
            if one.body.bound is not None and one.body.floor is not building.floor_of(one.body.bound)
        )
        robot = next(riding, None)
        if robot is None:
            self.floor = self.destination
            self.session = ""
        elif robot.body.bound is not None:
            self.floor = robot.body.floor.name
            self.session = robot.name
            self.destination = building.floor_of(robot.body.bound).name


class SimDoor:
    """A door of a floor, which opens for any robot that is near."""

    def __init__(self, name: str, floor: str, spot: tuple[float, float]) -> None:
        self.name = f"{floor}_{name}"
        self.floor = floor
        self.spot = spot
        self.mode = CLOSED
        self._for = 0.0
        self.is_offline = False

    def step(self, members: Mapping[str, SimMember], dt: float) -> None:
        """Open for robots nearby, and close some seconds after the last."""
        x, y = self.spot
        near = any(
            one.body.floor.name == self.floor and abs(one.body.pose.x - x) + abs(one.body.pose.y - y) < NEAR
            for one in members.values()
        )
        self._for = OPEN_FOR if near else max(0.0, self._for - dt)
        self.mode = OFFLINE if self.is_offline else OPEN if self._for else CLOSED
