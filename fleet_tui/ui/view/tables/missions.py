"""Orders as an operator reads them: by the labels of their stops."""

from collections.abc import Iterator
from functools import partial

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import Progress
from fleet_tui.model.order import Order, Stop, pose_text, route_text
from fleet_tui.model.robot import Robot
from fleet_tui.orders.goals import own_ids
from fleet_tui.orders.local_queue import foreign
from fleet_tui.text.language import Message, counted, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age


def distance_left(state: FleetState, robot: Robot, order: Order) -> float | None:
    """Return the metres left of the current order: as the robot reports them, else along the graph from its
    pose. None without fresh data."""
    if not robot.orders.is_current(order) or not state.is_online(robot):
        return None
    reported = _reported(state, robot, order)
    if reported is not None and reported.metres is not None:
        return reported.metres
    if not state.is_fresh(robot, "pose"):
        return None
    from fleet_tui.commands.routes.remaining import metres_left  # numpy: the first picture can do without

    return metres_left(robot, order)


def left_text(state: FleetState, robot: Robot, order: Order) -> str:
    """Return what is left of the current order: `12 m`, else the time as reported, else `3 nodes` of a
    vehicle; empty if it is unknown."""
    metres = distance_left(state, robot, order)
    if metres is not None:
        return f"{_figure(metres)} m"
    reported = _reported(state, robot, order)
    if reported is not None and reported.seconds is not None:
        return age(reported.seconds)
    nodes = _nodes_left(state, robot, order)
    return translate(counted("{count} node", "{count} nodes", nodes)) if nodes else ""


def progress_text(state: FleetState, robot: Robot, order: Order, has_left: bool = False) -> str:
    """Return the progress of the current order: `12 m left, 31 s, stop 1 of 2, 2 recoveries`, of a vehicle
    `3 nodes left`; empty without fresh data. `has_left`: a column tells what is left."""
    nodes, reported = _nodes_left(state, robot, order), _reported(state, robot, order)
    if nodes and not has_left:
        return translate(counted("{count} node left", "{count} nodes left", nodes))
    if nodes is not None or reported is None:
        return ""
    if has_left:
        return ", ".join(_stops_and_recoveries(reported, order))
    parts = []
    if reported.metres is not None:
        parts.append(tr("{metres} m left", metres=_figure(reported.metres)))
    if reported.seconds is not None:
        parts.append(age(reported.seconds) if parts else tr("{age} left", age=age(reported.seconds)))
    return ", ".join([*parts, *_stops_and_recoveries(reported, order)])


def _stops_and_recoveries(reported: Progress, order: Order) -> Iterator[str]:
    if reported.stop is not None and len(order.stops) > 1:
        stops = len(order.stops)
        yield tr("stop {stop} of {stops}", stop=min(reported.stop + 1, stops), stops=stops)
    if reported.recoveries:
        yield translate(counted("{count} recovery", "{count} recoveries", reported.recoveries))


def _figure(metres: float) -> str:
    return f"{metres:.{int(metres < 10)}f}"


def _reported(state: FleetState, robot: Robot, order: Order) -> Progress | None:
    is_known = robot.orders.is_current(order) and state.is_fresh(robot, "progress")
    return robot.progress.value if robot.progress is not None and is_known else None


def _nodes_left(state: FleetState, robot: Robot, order: Order) -> int | None:
    """Return the number of nodes that a vehicle has left, None if it is none or its state is old."""
    if robot.vehicle is None or not robot.orders.is_current(order) or not state.is_fresh(robot, "vehicle"):
        return None
    return len(robot.vehicle.value.nodes_left) + robot.vehicle.value.horizon


FOREIGN = Message(" (elsewhere)")


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
    return mission(robot, order) + ("" if ours else translate(FOREIGN))


def way(robot: Robot, stops: tuple[Stop, ...]) -> str:
    """Return stops by their labels."""
    return translate(route_text(stops, partial(place, robot)))
