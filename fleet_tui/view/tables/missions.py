"""Orders as an operator reads them: by the labels of their stops."""

from functools import partial

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order, Stop, pose_text, route_text
from fleet_tui.model.robot import Robot
from fleet_tui.rules.commands.goals import own_ids
from fleet_tui.rules.commands.local_queue import foreign
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize

FOREIGN = " (elsewhere)"


def place(robot: Robot, vertex: str) -> str:
    """Return a vertex as an operator reads it; one missing from every graph of the robot is marked."""
    name = robot.name_of(vertex)
    return sanitize(name) if name is not None else f"{sanitize(vertex)}?"


def mission(robot: Robot, order: Order) -> str:
    """Return `A -> B` by labels."""
    return sanitize(order.label) if order.label and not order.stops else way(robot, order.stops)


def destinations(robot: Robot, order: Order) -> str:
    """Return an order without its start, `-> B`, empty for one without two stops."""
    names = [place(robot, stop.vertex) if stop.pose is None else pose_text(stop.pose) for stop in order.stops]
    return "".join(f"-> {name} " for name in names[1:]).rstrip()


def whose_mission(state: FleetState, robot: Robot, order: Order) -> str:
    """Return the mission, marked if another client gave it, for robots without a queue. An order that says
    by itself that it is this operator's, from another of his consoles, is his own."""
    ours = not robot.kind.keeps_goals or order.is_over or order.id in own_ids(robot.goals)
    ours = ours or order not in foreign(state, robot)
    return mission(robot, order) + ("" if ours else tr(FOREIGN))


def way(robot: Robot, stops: tuple[Stop, ...]) -> str:
    """Return stops by their labels."""
    return route_text(stops, partial(place, robot)) if stops else tr(route_text((), str))
