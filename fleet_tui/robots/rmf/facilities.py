"""States of lifts, doors, dispensers, ingestors and lanes as events: one message has one of them."""

from collections.abc import Iterable

import msgspec

from fleet_tui.model import events
from fleet_tui.model.fleets import facility
from fleet_tui.model.fleets.events import FacilityReported
from fleet_tui.model.fleets.facility import Facility
from fleet_tui.robots.rmf.fleets import Read
from fleet_tui.robots.ros import messages as ros
from fleet_tui.text.language import EMPTY, Message, joined
from fleet_tui.text.limits import LONGEST_NAME, MOST_EDGES, truncate

DOORS = (Message("closed"), Message("moving"), Message("open"), Message("offline"), Message("state unknown"))
"""Modes of rmf_door_msgs/DoorMode, by number."""
DOORS_OF_LIFTS = (Message("doors closed"), Message("doors moving"), Message("doors open"))
LIFT_MODES = (
    Message("mode unknown"),
    Message("human mode"),
    EMPTY,
    Message("fire mode"),
    Message("offline"),
    Message("emergency mode"),
)
"""Modes of rmf_lift_msgs/LiftState, by number; empty: robots may use it."""
FAULTS = frozenset({"fire mode", "offline", "emergency mode"})
WORK = (Message("idle"), Message("busy"), Message("offline"))
"""Modes of dispensers and ingestors, by number."""


class LiftMessage(msgspec.Struct, frozen=True):
    """rmf_lift_msgs/LiftState. `session_id`: the fleet and the robot that have it, or another client."""

    lift_name: str
    current_floor: str = ""
    destination_floor: str = ""
    door_state: int = 0
    current_mode: int = 2
    session_id: str = ""


class DoorModeMessage(msgspec.Struct, frozen=True):
    """rmf_door_msgs/DoorMode."""

    value: int


class DoorMessage(msgspec.Struct, frozen=True):
    """rmf_door_msgs/DoorState."""

    door_name: str
    current_mode: DoorModeMessage


class WorkMessage(msgspec.Struct, frozen=True):
    """rmf_dispenser_msgs/DispenserState, and rmf_ingestor_msgs/IngestorState."""

    guid: str
    mode: int
    request_guid_queue: list[str] = []
    seconds_remaining: float = 0.0


class LanesMessage(msgspec.Struct, frozen=True):
    """rmf_fleet_msgs/LaneStates: the closed ones by their numbers in the fleet's navigation graph."""

    fleet_name: str
    closed_lanes: list[int] = []


def read_lifts() -> Read:
    """Read a rmf_lift_msgs/LiftState."""
    read = ros.reader(LiftMessage)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        lift = read(msg)
        mode = _word(LIFT_MODES, lift.current_mode)
        here, to = lift.current_floor, lift.destination_floor
        place = (
            Message("{here} to {to}", here=here, to=to)
            if to and to != here
            else Message("at {here}", here=here)
            if here
            else ""
        )
        text = joined(", ", filter(None, (mode, place, _word(DOORS_OF_LIFTS, lift.door_state))))
        fault = mode if mode in FAULTS else ""
        yield from _event(robots, Facility(facility.LIFT, lift.lift_name, at, text, fault, lift.session_id))

    return facts


def read_doors() -> Read:
    """Read a rmf_door_msgs/DoorState."""
    read = ros.reader(DoorMessage)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        door = read(msg)
        mode = _word(DOORS, door.current_mode.value)
        fault = mode if mode in FAULTS else ""
        yield from _event(robots, Facility(facility.DOOR, door.door_name, at, mode, fault))

    return facts


def read_work(sort: str) -> Read:
    """Return a reader of the states of dispensers or ingestors."""
    read = ros.reader(WorkMessage)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        one = read(msg)
        mode, waiting = _word(WORK, one.mode), len(one.request_guid_queue)
        left = (
            Message("{seconds_remaining} s left", seconds_remaining=f"{one.seconds_remaining:.0f}")
            if 0.0 < one.seconds_remaining < 1e6
            else ""
        )
        text = joined(
            ", ",
            filter(None, (mode, Message("{waiting} requests", waiting=waiting) if waiting > 1 else "", left)),
        )
        yield from _event(robots, Facility(sort, one.guid, at, text, mode if mode in FAULTS else ""))

    return facts


def read_lanes() -> Read:
    """Read a rmf_fleet_msgs/LaneStates."""
    read = ros.reader(LanesMessage)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        lanes = read(msg)
        closed = tuple(map(str, lanes.closed_lanes[:MOST_EDGES]))
        yield from _event(robots, Facility(facility.LANES, lanes.fleet_name, at, closed=closed))

    return facts


def _event(robots: frozenset[str], one: Facility) -> Iterable[events.Event]:
    """Return the report over the link of these robots."""
    name, state, user = (truncate(text, LONGEST_NAME) for text in (one.name, one.state, one.user))
    if name and robots:
        yield FacilityReported(
            min(robots), one.at, msgspec.structs.replace(one, name=name, state=state, user=user)
        )


def _word(words: tuple[Message, ...], number: int) -> Message:
    return words[number] if 0 <= number < len(words) else Message("mode {number}", number=number)


READERS = {
    "lifts": read_lifts,
    "doors": read_doors,
    "dispensers": lambda: read_work(facility.DISPENSER),
    "ingestors": lambda: read_work(facility.INGESTOR),
    "lanes": read_lanes,
}
"""Makers of readers by the keys of topics, which a site may lack."""
