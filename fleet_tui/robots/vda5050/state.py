"""The state of a vehicle, from the messages of all versions."""

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import NamedTuple

from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.vehicles.vehicle import CANCEL, INSTANT, Vehicle, VehicleAction, VehicleError
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_WORDS

MOST_NODES = 2000
MOST_ERRORS = 100
MOST_ACTIONS = 500
MOST_REFERENCES = 20
MOST_REQUESTS = 20
MOST_MAPS = 100
"""Maximum parts of one state."""
ENDED = frozenset({"FINISHED", "FAILED"})
"""States of an action that is over."""


Listed = frozenset[tuple[str, float | None]]


class OrderNodes(NamedTuple):
    """The nodes of an order that are left: the `released` ones by id, the number of the others, the last of
    all, and whether the vehicle is at the end of the released ones. `graph` are those with a place, `frame`
    is their map. `listed`: id and number of each that the states of the order have listed so far."""

    released: tuple[str, ...]
    horizon: int
    target: str
    is_at_base_end: bool
    graph: RouteGraph
    frame: str
    listed: Listed


def nodes_of(state: Fields, earlier: Listed = frozenset()) -> OrderNodes:
    """Return the nodes that are left of the order in a state; `earlier` are those that its states before it
    listed."""
    listed = sorted(state.parts(MOST_NODES, "nodeStates") or [], key=_sequence)
    known = earlier.union((node.text("nodeId"), node.number("sequenceId")) for node in listed)
    nodes = _without_passed(state, listed, known)
    edges = state.parts(MOST_NODES, "edgeStates") or []
    released = [node for node in nodes if node.flag("released") is not False]
    horizon = len(nodes) - len(released)
    return OrderNodes(
        tuple(node.text("nodeId") for node in released),
        horizon,
        listed[-1].text("nodeId") if listed else "",
        horizon > 0 and not released and not any(one.flag("released") for one in edges),
        *graph_of(state, "nodeStates", "edgeStates"),
        known,
    )


def _without_passed(state: Fields, nodes: list[Fields], known: Listed) -> list[Fields]:
    """Return the nodes after the one where the vehicle was last: some keep those for ever. The number of that
    one is another order's unless this one has listed its node."""
    last = state.text("lastNodeId"), state.number("lastNodeSequenceId")
    if not last[0] or last[1] is None or last not in known:
        return nodes
    return [node for node in nodes if _sequence(node) > last[1]]


def vehicle_of(state: Fields, base: str, nodes: OrderNodes, instant: Mapping[str, str]) -> Vehicle:
    """Return the state of a vehicle, whose topics have the base `base`. `instant` are the types of instant
    actions that were seen to be sent, by id: states need not name them."""
    position, power = _position(state), state.part("batteryState", "powerSupply")
    safety, asks = state.part("safetyState"), tuple(_requests(state))
    maps = tuple(_enabled(state, "maps", "map"))
    map_id = position.id("mapId") if position else ""
    actions = tuple(_actions(state, instant))
    driving = state.flag("driving")
    has_nodes = bool(nodes.released or nodes.horizon)
    goes_on = driving is True or any(action.is_carried_out for action in actions)
    return Vehicle(
        base,
        state.text("version"),
        mode=state.word("operatingMode"),
        driving=driving,
        charging=power.flag("charging") if power else None,
        localised=position.flag("positionInitialized", "localized") if position else None,
        is_placed=position is not None,
        e_stop=_e_stop(safety) if safety else "",
        field_violation=safety.flag("fieldViolation") if safety else None,
        last_node=state.text("lastNodeId"),
        distance=state.number("distanceSinceLastNode"),
        nodes_left=nodes.released,
        horizon=nodes.horizon,
        # They ask for more before they need it, and some at the end of an order as well.
        waits=not goes_on
        and (nodes.is_at_base_end or (has_nodes and state.flag("newBaseRequest") is True) or bool(asks)),
        asks=asks,
        maps=maps,
        zone_sets=tuple(_enabled(state, "zoneSets", "zoneSet")),
        map_off=map_id if map_id not in maps and state.parts(MOST_MAPS, "maps") else "",
        load=_load(state),
        order_id=state.text("orderId"),
        paused=state.flag("paused"),
        speed=_speed(state),
        errors=tuple(_errors(state)),
        actions=actions,
    )


def _requests(state: Fields) -> Iterator[str]:
    """Yield what a vehicle asks its master control for, and is not granted: 3.0 has zones that must be
    released, and corridors beside edges."""
    for one in state.parts(MOST_REQUESTS, "zoneRequests") or []:
        is_route = one.word("requestType") == "REPLANNING"
        what = Message("a new route in zone") if is_route else Message("zone")
        yield from _asked(one, Message("{what} {zone}", what=what, zone=one.id("zoneId")))
    for one in state.parts(MOST_REQUESTS, "edgeRequests") or []:
        yield from _asked(one, Message("the corridor of edge {id}", id=one.id("edgeId")))


def _asked(request: Fields, what: str) -> Iterator[str]:
    status = request.word("requestStatus")
    if status != "GRANTED":
        yield what if status in ("", "REQUESTED") else f"{what} ({status.lower()})"


def _enabled(state: Fields, name: str, what: str) -> Iterator[str]:
    """Yield the ids of the maps or zone sets that a vehicle uses."""
    for one in state.parts(MOST_MAPS, name) or []:
        if one.word(f"{what}Status") == "ENABLED":
            yield one.id(f"{what}Id")


def _speed(state: Fields) -> float | None:
    """Return the speed in m/s, whatever its direction."""
    velocity = state.part("velocity")
    vx, vy = (velocity.number("vx"), velocity.number("vy")) if velocity else (None, None)
    return None if vx is None and vy is None else math.hypot(vx or 0.0, vy or 0.0)


def _sequence(node: Fields) -> float:
    return node.number("sequenceId") or 0.0


def _e_stop(safety: Fields) -> str:
    word = safety.word("eStop", "activeEmergencyStop")
    return "" if word == "NONE" else word


def _load(state: Fields) -> str | None:
    loads = state.parts(MOST_ERRORS, "loads")
    if loads is None:
        return None
    names = [load.text("loadType") or load.text("loadId") or "load" for load in loads]
    return ", ".join(names)


def _errors(state: Fields) -> Iterator[VehicleError]:
    for error in state.parts(MOST_ERRORS, "errors") or []:
        references = error.parts(MOST_REFERENCES, "errorReferences") or []
        yield VehicleError(
            error.text("errorType") or "error",
            error.word("errorLevel"),
            error.text("errorDescription", longest=LONGEST_WORDS),
            error.text("errorHint", longest=LONGEST_WORDS),
            tuple((one.text("referenceKey"), one.id("referenceValue")) for one in references),
        )


def _actions(state: Fields, instant: Mapping[str, str]) -> Iterator[VehicleAction]:
    for name in ("actionStates", "instantActionStates"):
        for action in state.parts(MOST_ACTIONS, name) or []:
            id_ = action.text("actionId")
            type_ = action.text("actionType") or instant.get(id_, "")
            yield VehicleAction(
                id_,
                action.word("actionStatus"),
                action.text("resultDescription", "actionResult", longest=LONGEST_WORDS),
                type_,
                is_beside=id_ in instant or type_ in INSTANT or name == "instantActionStates",
            )


def _position(message: Fields) -> Fields | None:
    return message.part("agvPosition", "mobileRobotPosition")


def pose_of(message: Fields) -> tuple[Pose, str] | None:
    """Return the pose in a state or visualization, and the map that it is on; None without one."""
    position = _position(message)
    if position is None:
        return None
    x, y, theta = position.number("x"), position.number("y"), position.number("theta")
    if x is None or y is None:
        return None
    return Pose(x, y, theta if theta is not None else 0.0), position.id("mapId")


def charge_of(state: Fields) -> float | None:
    """Return the charge in per cent."""
    power = state.part("batteryState", "powerSupply")
    charge = power.number("batteryCharge", "stateOfCharge") if power else None
    if charge is None or 0.0 <= charge <= 101.0:
        return charge
    state.faults.append(Message("charge is {charge}, not between 0 and 100", charge=f"{charge:g}"))
    return None


def is_running(vehicle: Vehicle, is_cancelled: bool = False) -> bool:
    """Tell whether its order is driven: it stays in the state after its end, and after its cancellation, some
    with actions that wait for ever. Of the actions beside it only its cancellation counts."""
    over = {*ENDED, "WAITING"} if is_cancelled else ENDED
    going = any(
        one.status and one.status not in over
        for one in vehicle.actions
        if not one.is_beside or one.type == CANCEL
    )
    return bool(vehicle.order_id) and bool(vehicle.nodes_left or vehicle.horizon or going)


def graph_of(message: Fields, nodes: str, edges: str) -> tuple[RouteGraph, str]:
    """Return the nodes of an order whose places are known with the edges between them, and their map."""
    vertices, frame = dict[str, Vertex](), ""
    for node in message.parts(MOST_NODES, nodes) or []:
        place, id_ = node.part("nodePosition"), node.text("nodeId")
        x, y = (place.number("x"), place.number("y")) if place else (None, None)
        if id_ and place and x is not None and y is not None:
            vertices[id_] = Vertex(id_, x, y)
            frame = frame or place.id("mapId")
    ways = []
    for edge in message.parts(MOST_NODES, edges) or []:
        id_, start, end = edge.text("edgeId"), edge.text("startNodeId"), edge.text("endNodeId")
        if start in vertices and end in vertices:
            ways.append(Edge(id_, start, end))
    if not ways:  # the edges of a state don't say where they lead: one after the other
        ids = [node.text("nodeId") for node in sorted(message.parts(MOST_NODES, nodes) or [], key=_sequence)]
        known = [id_ for id_ in ids if id_ in vertices]
        ways = [Edge(f"{a} {b}", a, b) for a, b in pairwise(known) if a != b]
    return RouteGraph(vertices, tuple(ways), True), frame
