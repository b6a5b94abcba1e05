"""The object of a request, remembered while its question is open: a yes is about what was asked."""

from collections.abc import Iterator

from msgspec import Struct

from fleet_tui.model.commands import CancelOrder, ClearOrders, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order, vertices_of
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import CancelGoal
from fleet_tui.orders.goals import active
from fleet_tui.orders.local_queue import all_orders, clearable
from fleet_tui.text.language import Message


class Subject(Struct, frozen=True):
    """Orders that a request removes, by robot; the labels of places that it names, by robot and vertex,
    with the floor on which the robot takes them; the goals that it cancels, by robot; the paused
    robots that it resumes. `at`: when that
    was so (monotonic)."""

    at: float
    orders: dict[str, tuple[Order, ...]]
    places: dict[tuple[str, str], tuple[str | None, str]]
    goals: dict[str, tuple[str, ...]]
    paused: frozenset[str]


def subject_of(state: FleetState, request: Request) -> Subject:
    """Return what a request is about now."""
    orders: dict[str, tuple[Order, ...]] = {}
    places: dict[tuple[str, str], tuple[str | None, str]] = {}
    goals: dict[str, tuple[str, ...]] = {}
    for command in request.commands:
        robot = state.robots[command.robot]
        if isinstance(command, CancelOrder):
            named = tuple(order for order in all_orders(state, robot) if order.id == command.order_id)
            orders[robot.name] = orders.get(robot.name, ()) + named
        elif isinstance(command, ClearOrders):
            orders[robot.name] = tuple(clearable(state, robot))
        elif isinstance(command, PlaceOrder):
            places |= {(robot.name, id_): _place(robot, id_) for id_ in vertices_of(command.stops)}
        elif isinstance(command, CancelGoal):
            goals[robot.name] = tuple(goal.id for goal in active(robot.goals))
    resumed = {command.robot for command in request.commands if isinstance(command, ResumeRobot)}
    paused = frozenset(name for name in resumed if state.is_paused(state.robots[name]))
    return Subject(state.now, orders, places, goals, paused)


def _place(robot: Robot, vertex: str) -> tuple[str | None, str]:
    """Return the label of a vertex, and the floor on which a robot takes it, if several have it."""
    graphs = {name: known.graph for name, known in robot.maps.items() if known.graph is not None}
    is_shared = sum(vertex in graph.vertices for graph in graphs.values()) > 1
    return robot.name_of(vertex), (robot.floor or "") if is_shared else ""


def what_changed(state: FleetState, request: Request, asked: Subject) -> str:
    """Return what is no longer as it was asked about, empty for nothing. A clear may lose fewer orders than
    were listed, never others."""
    return next(_changes(state, subject_of(state, request), asked), "")


def _changes(state: FleetState, now: Subject, asked: Subject) -> Iterator[str]:
    for name, orders in asked.orders.items():
        gone = {one.order.id for one in state.robots[name].gone if one.at >= asked.at}
        before = {order.id: order for order in orders}
        for order in now.orders.get(name, ()):
            if order.id not in before:
                yield Message("{name} has another order, {id}", name=name, id=order.id)
            elif order.id in gone or order.stops != before[order.id].stops:
                yield Message("order {id} of {name} is a different one now", id=order.id, name=name)
    for (name, vertex), place in asked.places.items():
        if now.places.get((name, vertex)) != place:
            yield Message("vertex {vertex} of {name} is a different place now", vertex=vertex, name=name)
    for name, goals in asked.goals.items():
        if not set(now.goals.get(name, ())) <= set(goals):
            yield Message("{name} has another goal now", name=name)
    for name in sorted(asked.paused - now.paused):
        yield Message("{name} is no longer paused", name=name)
