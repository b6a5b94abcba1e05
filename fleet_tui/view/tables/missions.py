"""Orders as an operator reads them: by the labels of their stops."""

from functools import partial

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order, Stop, pose_text, route_text
from fleet_tui.model.robot import Robot
from fleet_tui.rules.commands.goals import own_ids
from fleet_tui.rules.commands.local_queue import foreign
from fleet_tui.text.language import Message, counted, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age


def progress_text(state: FleetState, robot: Robot, order: Order) -> str:
    """Return the progress of the current order: `12.5 m left, 31 s, stop 1 of 2, 2 recoveries`, of a vehicle
    `3 nodes left`; empty without fresh data."""
    vehicle = robot.vehicle.value if robot.vehicle is not None else None
    if vehicle is not None and robot.orders.is_current(order) and state.is_fresh(robot, "vehicle"):
        left = len(vehicle.nodes_left) + vehicle.horizon
        return translate(counted("{count} node left", "{count} nodes left", left)) if left else ""
    if robot.progress is None or not robot.orders.is_current(order) or not state.is_fresh(robot, "progress"):
        return ""
    reported = robot.progress.value
    parts = []
    if reported.metres is not None:
        parts.append(tr("{metres} m left", metres=f"{reported.metres:.{int(reported.metres < 100)}f}"))
    if reported.seconds is not None:
        parts.append(age(reported.seconds) if parts else tr("{age} left", age=age(reported.seconds)))
    if reported.stop is not None and len(order.stops) > 1:
        parts.append(
            tr(
                "stop {stop} of {stops}",
                stop=min(reported.stop + 1, len(order.stops)),
                stops=len(order.stops),
            )
        )
    if reported.recoveries:
        parts.append(translate(counted("{count} recovery", "{count} recoveries", reported.recoveries)))
    return ", ".join(parts)


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
