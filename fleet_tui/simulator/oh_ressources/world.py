"""The robots of the source's stack and their orders. Pure."""

from collections.abc import Mapping
from typing import Any

from fleet_tui.simulator.robot import LOW, SimRobot
from fleet_tui.simulator.warehouse import SimFloor
from fleet_tui.simulator.world import SimWorld

Values = dict[str, Any]

OWN_REQUESTS = 9000  # request ids of orders the warehouse itself makes start above this


class World(SimWorld[SimRobot]):
    """Robots that keep queues of orders, on floors that may be redrawn."""

    def __init__(
        self, robots: int, floors: int, seed: int = 0, quiet: bool = False, first: int = 0, step: int = 1
    ) -> None:
        super().__init__(robots, floors, seed, quiet, first, step)
        self._requests = OWN_REQUESTS
        self._silence_in = self._rng.uniform(180.0, 240.0)
        self._patience = dict.fromkeys(self.robots, 0.0)
        if not quiet:
            self._employ()

    def _live(self) -> None:
        for robot in self.robots.values():
            robot.step()

    def answer(self, service: str, args: Mapping[str, Any]) -> Values:
        _, name, _, verb = service.split("/")
        robot = self.robots[name]
        match verb:
            case "Execute_order":
                return self._order(robot, args["request_id"], args["initial_point"], args["end_point"])
            case "Execute_order_with_cargo":
                if not robot.cargo:
                    return _status(args["request_id"], "REJECTED: no cargo on board")
                return self._order(robot, args["request_id"], robot.vertex, args["end_point"], loaded=True)
            case "Cancel_order":
                return _cancel(robot, args["ind"])
            case "Clear_orders":
                return {"success": True, "status": f"cleared {_drop_all(robot)}"}
            case "Pause" | "Resume":
                robot.paused = verb == "Pause"
                return {"success": True, "message": "paused" if robot.paused else "running"}
        raise KeyError(service)

    def redraw(self, floor: SimFloor) -> None:
        """Replace the graph of a floor, which all robots share. Those on it go to the nearest vertex if
        theirs is gone; all plan their ways again."""
        homes = {name: robot.floor.name for name, robot in self.robots.items()}
        self.building.redraw(floor)
        known = self.building.graph.vertices
        for name, robot in self.robots.items():
            if homes[name] == floor.name:
                near = floor.graph.nearest(robot.pose.x, robot.pose.y)
                robot.vertex = robot.vertex if robot.vertex in known else near
                # It may have been moved, or the robot beside it.
                robot.bound = robot.bound if robot.bound in known else robot.vertex
            elif robot.bound not in known:
                robot.bound = None
            robot.restart()

    def _order(self, robot: SimRobot, request_id: int, start: int, end: int, loaded: bool = False) -> Values:
        for vertex in (start, end):
            if vertex not in self.building.graph.vertices:
                return _status(request_id, f"REJECTED: no vertex {vertex}")
        robot.take(start, end, request_id, loaded)
        return _status(request_id, "ACCEPTED")

    def _new_robot(self, turn: int, index: int) -> SimRobot:
        """Robots start in turn on all floors, spread over the vertices."""
        floor = self.building.floors[index % len(self.building.floors)]
        vertices = tuple(floor.graph.vertices)
        spot = 7 * (index // len(self.building.floors)) + 3 * index
        return SimRobot(index, self.building, vertices[spot % len(vertices)], self._rng, self._quiet)

    def _employ(self) -> None:
        """The warehouse's own orders: one for every robot that has been idle long enough."""
        for name, robot in self.robots.items():
            if robot.idle < self._patience[name] or robot.orders or robot.battery < LOW:
                continue
            self._patience[name] = self._rng.uniform(6.0, 15.0)
            if len(robot.floor.labels) < 2:  # as it may be on a drawn graph
                continue
            self._requests += 1
            start, end = self._trip(robot)
            if robot.cargo:
                robot.take(robot.vertex, end, self._requests, loaded=True)
            else:
                robot.take(start, end, self._requests)

    def _trip(self, robot: SimRobot) -> tuple[int, int]:
        """Two labelled vertices: mostly on the robot's floor, every fifth trip ends on any floor."""
        start, end = self._rng.sample(tuple(robot.floor.labels), 2)
        if self._rng.random() < 0.2:
            ends = [id_ for id_ in self._rng.choice(self.building.floors).labels if id_ != start]
            end = self._rng.choice(ends) if ends else end
        return start, end


def _status(request_id: int, status: str) -> Values:
    return {"request_id": request_id, "status": status}


def _drop_all(robot: SimRobot) -> int:
    return robot.drop({order.id for order in robot.orders})


def _cancel(robot: SimRobot, ind: int) -> Values:
    """Cancel an order. As on the real robots, an `ind` of 0 or less means all orders."""
    if ind <= 0:
        return {"success": True, "status": f"cancelled {_drop_all(robot)}"}
    if robot.drop({ind}):
        return {"success": True, "status": f"cancelled {ind}"}
    return {"success": False, "status": f"REJECTED: no order {ind}"}
