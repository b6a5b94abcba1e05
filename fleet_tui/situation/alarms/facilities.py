"""Facilities of sites out of service: the alarm, and what each is to a robot."""

from collections.abc import Iterator

from fleet_tui.model.alarm import Condition, Priority
from fleet_tui.model.desk.desk import Ends
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.facility import DOOR, LANES, LIFT, Facility
from fleet_tui.model.order import natural
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.units import age

SILENT_AFTER = 5.0
"""Seconds after which the state of a facility is said with its age: each is sent at least once a second."""


def listed(state: FleetState, link: str = "") -> list[Facility]:
    """Return the facilities, of one link if one is named: out of service first, then by sort and name."""
    found = [one for one in state.facilities.values() if link in ("", one.link) and one.sort != LANES]
    return sorted(
        found, key=lambda one: (one.fault == "", one.sort == DOOR, one.sort != LIFT, natural(one.name))
    )


def facility_text(state: FleetState, one: Facility) -> Message:
    """Return a facility with its state, its user, and the age of an old state."""
    user = Message(", used by {user}", user=one.user) if one.user else EMPTY
    old = state.now - one.at
    aged = Message(", {age} ago", age=age(old)) if old > SILENT_AFTER else EMPTY
    link = f" ({one.link})" if len(state.links) > 1 else ""
    return Message(
        "{sort} {name}{link}: {state}{user}{aged}",
        sort=Message(one.sort),
        name=one.name,
        link=link,
        state=one.state,
        user=user,
        aged=aged,
    )


def facility_conditions(state: FleetState) -> Iterator[Condition]:
    """Yield an alarm for each facility that is out of service by its last state."""
    for one in state.facilities.values():
        if one.fault:
            source = f"{one.link}: {one.name}" if len(state.links) > 1 else one.name
            yield Condition(
                source,
                "facility",
                Priority.MEDIUM,
                Message("{sort} {fault}", sort=Message(one.sort), fault=Message(one.fault)),
                Message("{sort} in service", sort=Message(one.sort)),
            )


def closed_edges(state: FleetState, robot: Robot, floor: str) -> list[Ends]:
    """Return the edges of a floor that the fleet of a robot has closed, in either direction."""
    lanes = state.facilities.get(f"{robot.link} {LANES} {robot.name.partition('/')[0]}")
    graph = robot.maps[floor].graph if floor in robot.maps else None
    if lanes is None or not lanes.closed or graph is None:
        return []
    closed = set(lanes.closed)
    found = (edge for edge in graph.edges if edge.id in closed or edge.reverse_id in closed)
    return [(floor, edge.start, edge.end) for edge in found]
