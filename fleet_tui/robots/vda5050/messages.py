"""Messages of vehicles and master controls as events."""

import calendar
import hashlib
import re
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from functools import lru_cache
from typing import NamedTuple

from fleet_tui.model import events
from fleet_tui.model.navigation import Goal
from fleet_tui.model.navigation_events import GoalsReported
from fleet_tui.model.order import OrderState, Stop
from fleet_tui.model.vehicles.events import (
    ConnectionReported,
    FactsheetReported,
    MasterSeen,
    NodesReported,
    VehicleReported,
)
from fleet_tui.model.vehicles.vehicle import HIGH, Vehicle, VehicleAction, VehicleConnection, VehicleFeatures
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.robots.vda5050.memory import StateMemory
from fleet_tui.robots.vda5050.state import MOST_ACTIONS, charge_of, graph_of, is_running, pose_of, vehicle_of
from fleet_tui.text.language import Message

ORDER = "order"
"""The key under which a vehicle's one order is listed."""
LONGEST_ID = 24
_UUID = re.compile(r"[0-9a-f]{8}-?(?:[0-9a-f]{4}-?){3}[0-9a-f]{12}", re.IGNORECASE)
_PLAIN = re.compile(r"[\w.:-]+")
MOST_FACTS = 100


_ISO = re.compile(
    r"(\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d):(\d\d)(\.\d{1,9})?(?:Z|([+-])(\d\d):?(\d\d))?",
    re.ASCII | re.IGNORECASE,
)


class MessageOrigin(NamedTuple):
    """The origin of a message: the robot, the base of its topics, the monotonic second of its arrival, and
    whether the broker had kept it. `owns` tells whether an order was given by this operator's consoles;
    `memory` has the states before."""

    robot: str
    base: str
    at: float
    is_kept: bool = False
    owns: Callable[[str], bool] = lambda _id: False
    memory: StateMemory = StateMemory()


def short_id(id_: str) -> str:
    """Return the id of an order as people write it: the first digits of a long random one, a hash of one that
    can't be typed."""
    if _UUID.fullmatch(id_):
        return id_[:8].lower()
    if len(id_) <= LONGEST_ID and _PLAIN.fullmatch(id_):
        return id_
    return hashlib.sha256(id_.encode(errors="replace")).hexdigest()[:8]


def stamp_of(message: Fields) -> float | None:
    """Return the Unix second of a message by its sender's clock, None without a usable one."""
    text = message.text("timestamp")
    found = unix_second(text)
    if text and found is None:
        message.faults.append(Message("timestamp is {text}, not ISO 8601", text=f"{text!r}"))
    return found


def read_state(origin: MessageOrigin, message: Fields) -> Iterator[events.Event]:
    """Read a state: everything that a vehicle reports."""
    robot, at = origin.robot, origin.at
    if origin.memory.has_second_sender(robot, message.number("headerId"), at):
        message.faults.append("headerId goes back again and again: two senders have this serial number")
    nodes, is_new = origin.memory.nodes(robot, message)
    vehicle = vehicle_of(message, origin.base, nodes, origin.memory.instant_actions)
    yield VehicleReported(robot, at, vehicle)
    for reported in _pose(origin, message, "state"):
        origin.memory.state_at(robot, reported.pose, at)
        yield reported
    charge = charge_of(message)
    if charge is not None:
        yield events.BatteryReported(robot, at, charge)
    if vehicle.load is not None:
        yield events.CargoReported(robot, at, bool(vehicle.load))
    if vehicle.paused is not None:
        yield events.PausedReported(robot, at, vehicle.paused)
    if is_new and nodes.graph.vertices:
        yield NodesReported(robot, at, nodes.frame, nodes.graph)
    ordered = origin.memory.with_driven_order(robot, vehicle)
    earlier = origin.memory.earlier_actions(robot, ordered)
    orders = _orders(ordered, nodes.target, origin.owns(ordered.order_id), earlier)
    is_over = any(goal.state is not OrderState.IN_PROCESS for goal in orders)
    if is_over and (_is_unread(message, "nodeStates") or _is_unread(message, "actionStates")):
        return  # what can't be read may be left of it
    if origin.memory.is_news(robot, orders, at):
        yield GoalsReported(robot, at, ORDER, orders)


def _is_unread(message: Fields, name: str) -> bool:
    """Tell whether a list has more than what is read of it."""
    value = message.raw(name)
    return bool(value) and not (isinstance(value, list) and all(isinstance(one, dict) for one in value))


def _orders(vehicle: Vehicle, target: str, is_ours: bool, earlier: Set[str]) -> tuple[Goal, ...]:
    """Return the one order of a vehicle, which it names even after its end. `earlier` are actions that are
    not of it."""
    if not vehicle.order_id:
        return ()
    actions = [one for one in vehicle.actions if not one.id or one.id not in earlier]
    is_cancelled = any(one.is_cancelled for one in actions)
    if is_running(vehicle, is_cancelled):
        state, said = OrderState.IN_PROCESS, ""
    elif is_cancelled:  # first: it makes the actions fail that were to follow
        state, said = OrderState.CANCELLED, ""
    else:
        state, said = _end(vehicle, actions)
    goal = Goal(
        short_id(vehicle.order_id),
        vehicle.order_id,
        ORDER,
        state,
        Message("{nodes_left} nodes left", nodes_left=len(vehicle.nodes_left)),
        stops=(Stop(target),) if target else (),
        is_ours=is_ours,
        said=said,
    )
    return (goal,)


def _end(vehicle: Vehicle, actions: Sequence[VehicleAction]) -> tuple[OrderState, str]:
    """Return how an order with these actions ended, with the vehicle's text: it is done if all its parts
    are."""
    if any(one.level in HIGH and one.concerns(vehicle.order_id) for one in vehicle.errors):
        return OrderState.FAILED, ""
    for one in actions:
        if one.status == "FAILED" and not one.is_beside:
            return OrderState.FAILED, ": ".join(
                filter(None, (Message("{action} failed", action=one.type or "action"), one.text))
            )
    return OrderState.DONE, ""


def read_visualization(origin: MessageOrigin, message: Fields) -> Iterator[events.Event]:
    """Read a visualization: the pose alone. One that contradicts the states is named, and not believed."""
    for reported in _pose(origin, message, "visualization"):
        metres = origin.memory.apart(origin.robot, reported.pose, origin.at)
        if metres:
            message.faults.append(
                Message(
                    "position {metres} m from that of the previous state: ignored", metres=f"{metres:.1f}"
                )
            )
        else:
            yield reported


def _pose(origin: MessageOrigin, message: Fields, name: str) -> Iterator[events.PoseReported]:
    """Read a pose. Where its clock stands still, it is as old as its message."""
    found, stamp = pose_of(message), stamp_of(message)
    text, number = message.text("timestamp"), message.number("headerId")
    if origin.memory.clock_stands(origin.robot, name, text, number, origin.at):
        message.faults.append(Message("clock stopped: {text} in all messages", text=text))
        stamp = None
    if found is not None:
        yield events.PoseReported(origin.robot, origin.at, *found, stamp)


def read_connection(origin: MessageOrigin, message: Fields) -> Iterator[events.Event]:
    """Read a connection message. Its timestamp sets no clock: a last will has that of connecting."""
    connection = VehicleConnection(message.word("connectionState"), origin.base, message.text("version"))
    yield ConnectionReported(origin.robot, origin.at, connection, origin.is_kept)


def read_factsheet(origin: MessageOrigin, message: Fields) -> Iterator[events.Event]:
    """Read a factsheet: the simple values of its parts, and what the vehicle takes."""
    facts = dict[str, str]()
    for name in ("typeSpecification", "physicalParameters"):
        part = message.part(name)
        facts |= dict(part.shown()) if part else {}
    protocol = message.part("protocolFeatures")
    features = VehicleFeatures(
        _parameters(protocol), _actions(protocol, "NODE"), _actions(protocol, "INSTANT")
    )
    yield FactsheetReported(origin.robot, origin.at, dict(list(facts.items())[:MOST_FACTS]), features)


def _parameters(protocol: Fields | None) -> tuple[str, ...] | None:
    listed = protocol.parts(MOST_FACTS, "optionalParameters") if protocol is not None else None
    return None if listed is None else tuple(one.text("parameter") for one in listed)


def _actions(protocol: Fields | None, scope: str) -> tuple[str, ...]:
    """Return the types of the actions that a vehicle takes in a scope, or without any."""
    listed = protocol.parts(MOST_FACTS, "agvActions", "mobileRobotActions") if protocol is not None else None
    return tuple(
        one.text("actionType")
        for one in listed or ()
        if not (scopes := one.raw("actionScopes")) or (isinstance(scopes, list) and scope in scopes)
    )


def read_order(origin: MessageOrigin, message: Fields) -> Iterator[events.Event]:
    """Read an order of a master control: its whole route."""
    id_ = message.text("orderId")
    yield MasterSeen(origin.robot, origin.at, Message("order {short_id}", short_id=short_id(id_)), (id_,))
    graph, frame = graph_of(message, "nodes", "edges")
    if graph.vertices:
        yield NodesReported(origin.robot, origin.at, frame, graph)


def read_actions(origin: MessageOrigin, message: Fields) -> Iterator[events.Event]:
    """Read the instant actions of a master control."""
    found = message.parts(MOST_ACTIONS, "actions", "instantActions") or []
    for one in found:
        origin.memory.add_instant(one.text("actionId"), one.text("actionType"))
    what = ", ".join(one.text("actionType") for one in found[:3]) or Message("instant actions")
    yield MasterSeen(origin.robot, origin.at, what, tuple(one.text("actionId") for one in found))


READERS: Mapping[str, Callable[[MessageOrigin, Fields], Iterator[events.Event]]] = {
    "state": read_state,
    "visualization": read_visualization,
    "connection": read_connection,
    "factsheet": read_factsheet,
    "order": read_order,
    "instantActions": read_actions,
}
"""By the name of a topic. None raises an error: what can't be read is among the faults of the message."""


def unix_second(text: str) -> float | None:
    """Return the Unix second of a timestamp, None if it is none."""
    found = _ISO.fullmatch(text)
    if found is None:
        return None
    seconds = _whole_second(text[:19])
    if seconds is None:
        return None
    fraction, sign, hours, minutes = found.groups()[6:]
    whole = seconds + float(fraction or 0.0)
    if sign is None:
        return whole
    offset = 3600 * int(hours) + 60 * int(minutes)
    return whole - offset if sign == "+" else whole + offset


@lru_cache(maxsize=256)
def _whole_second(text: str) -> int | None:
    """Return the Unix second of `2026-01-02T03:04:05`: many vehicles have the same."""
    year, month, day = int(text[:4]), int(text[5:7]), int(text[8:10])
    hour, minute, second = int(text[11:13]), int(text[14:16]), int(text[17:19])
    is_date = year >= 1970 and 1 <= month <= 12 and 1 <= day <= 31
    if not (is_date and hour < 24 and minute < 60 and second <= 60):
        return None
    return calendar.timegm((year, month, day, hour, minute, second))
