"""Log messages of robots with Nav2: lines of /rosout."""

from collections.abc import Iterator

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.logs import ERROR, INFO, WARN
from fleet_tui.simulator.nav2.navigation import TO_POSE, SimNavigation
from fleet_tui.simulator.nav2.world import Nav2World
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.ros.goals import ABORTED, CANCELED, EXECUTING, SUCCEEDED

_ENDS = {
    SUCCEEDED: (INFO, "Goal succeeded"),
    CANCELED: (INFO, "Goal canceled"),
    ABORTED: (ERROR, "Goal failed"),
}


class Nav2Changes:
    """Detects the changes of robots between two calls."""

    def __init__(self, world: Nav2World) -> None:
        self._world = world
        self._statuses: dict[bytes, int] = {}
        self._blocked: set[str] = set()

    def lines(self) -> Iterator[Line]:
        statuses: dict[bytes, int] = {}
        for name, navigation in self._world.navigation.items():
            said = [*self._goals(name, navigation, statuses), *self._obstacle(navigation.robot)]
            if not navigation.robot.silence:
                yield from said
        self._statuses = statuses

    def _goals(self, name: str, navigation: SimNavigation, statuses: dict[bytes, int]) -> Iterator[Line]:
        while navigation.complaints:
            level, node, text = navigation.complaints.pop(0)
            yield level, f"/{name}/{node}", text
        for goal in navigation.servers[TO_POSE].goals.values():
            before, statuses[goal.id] = self._statuses.get(goal.id), goal.status
            if before == goal.status:
                continue
            if goal.status == EXECUTING:
                at = goal.request["pose"]["pose"]["position"]
                message = f"Begin navigating from current location to ({at['x']:.2f}, {at['y']:.2f})"
                yield INFO, f"/{name}/bt_navigator", message
            elif goal.over:
                level, message = _ENDS[goal.status]
                code = goal.result.get("error_code")
                why = f" error_code:{code} error_msg:{goal.result['error_msg']}." if code else ""
                yield level, f"/{name}/bt_navigator", message + why

    def _obstacle(self, robot: NavigatingRobot) -> Iterator[Line]:
        blocked = robot.obstacle > 0.0
        if robot.driving and blocked != (robot.name in self._blocked):
            self._blocked ^= {robot.name}
            message = (
                "Robot to stop due to PolygonStop polygon"
                if blocked
                else "Robot to continue normal operation"
            )
            yield (WARN if blocked else INFO), f"/{robot.name}/collision_monitor", message
