"""The fleet state: everything known at one instant."""

from collections.abc import Iterable, Mapping

from msgspec import Struct, field
from msgspec.structs import replace

from fleet_tui.model.alarm import Alarm, AlarmStage, Key
from fleet_tui.model.commands import CommandRecord
from fleet_tui.model.desk.desk import Desk, Ends
from fleet_tui.model.fleets.facility import Facility
from fleet_tui.model.geometry import Line
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.units import age, duration

CONTACT = 3.0
"""Seconds of contact, or of a stop, from which an obstacle blocks a robot: shorter ones are usual."""
MANY = 50
CROWD = 300
"""Robots from which the rules look at each twice a second, not in every tick; those from which pictures and
rows are made less often, too."""


class Limits(Struct, frozen=True, kw_only=True):
    """Alarm limits: seconds and per cent.

    A battery alarm ends `battery_band` above its limit, any alarm when its condition has been absent for
    `clear_after`; `shelve_for` is the duration of shelving; alarms of the classes `latched` stay until they
    are acknowledged.
    """

    offline_after: float = 5.0
    obstacle_after: float = 30.0
    battery_low: float = 20.0
    battery_critical: float = 10.0
    link_after: float = 2.0
    confirm_after: float = 5.0
    stuck_after: float = 60.0
    pause_after: float = 300.0
    battery_band: float = 2.0
    clear_after: float = 3.0
    shelve_for: float = 1800.0
    latched: tuple[str, ...] | None = None


class Floor(Struct, frozen=True, eq=False):
    """A floor of the config. `grid` is its configured map file; `tied` is False if that is a plain image
    placed by map_metadata; `problem` is the reason it can't be shown, `graph_problem` that of its graph
    file; `live` is the map that robots share, `live_at` the time of its arrival."""

    name: str
    frame_id: str
    grid: OccupancyGrid | None = None
    tied: bool = True
    problem: Message = EMPTY
    graph_problem: Message = EMPTY
    live: OccupancyGrid | None = None
    live_at: float | None = None


class BlockedEdge(Struct, frozen=True):
    """An edge on which a robot is held up: `spans` are the parts of it that others on it have driven,
    `passed` is True once one of them drove all of it."""

    ends: Ends
    spans: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    passed: bool = False


class Deadlock(Struct, frozen=True):
    """A robot waits for another one, which waits for it, since a monotonic second; `way`: its next edges."""

    other: str
    since: float
    way: tuple[Line, ...] = ()


class FleetState(Struct, frozen=True, eq=False):
    """Everything known at one instant. `now` is monotonic, `wall` Unix time, both of the last tick; `began`
    is the start of each condition, alarm or not yet; `behind`: seconds by which this console reads messages
    late, which count against no robot, `behind_at` when that was last a second or more; `desk`: its people;
    `facilities` are the lifts, doors and the like of sites, by key; `blocked` are the edges on which robots
    are held up, `deadlocks` those that wait for each other, by robot."""

    floors: Mapping[str, Floor]
    robots: Mapping[str, Robot]
    links: Mapping[str, LinkState]
    limits: Limits = field(default_factory=Limits)
    alarms: tuple[Alarm, ...] = ()
    began: Mapping[Key, float] = field(default_factory=dict)
    commands: tuple[CommandRecord, ...] = ()
    now: float = 0.0
    wall: float = 0.0
    behind: float = 0.0
    behind_at: float = 0.0
    desk: Desk = Desk()
    facilities: Mapping[str, Facility] = field(default_factory=dict)
    blocked: Mapping[str, BlockedEdge] = field(default_factory=dict)
    deadlocks: Mapping[str, Deadlock] = field(default_factory=dict)

    def patience(self, robot: Robot) -> float:
        """Return the seconds of silence after which a robot counts as offline. Messages still unread by this
        console don't count against it."""
        return self._silence(robot) + self.behind

    def _silence(self, robot: Robot) -> float:
        return robot.kind.offline_after or self.limits.offline_after

    def is_online(self, robot: Robot) -> bool:
        """Tell whether its last message is within the limit, as much older as its link is late, and that
        was not lost since."""
        link, last = self.links[robot.link], robot.last_received
        if last is None or (link.phase is not Phase.UP and last < link.since):
            return False
        # As `patience`, which is not called: this is asked ten times of every robot in every tick.
        patience = (robot.kind.offline_after or self.limits.offline_after) + self.behind
        return self.now - last + link.late <= patience and not robot.is_gone

    def pause(self, robot: Robot) -> bool | None:
        """Tell whether it is paused, None if unknown: by the robot's own fresh report if it sends one, else
        by our accepted pause."""
        if robot.paused is not None:
            return robot.paused.value if self.is_fresh(robot, "paused") else None
        return True if robot.paused_by_us else None

    def is_paused(self, robot: Robot) -> bool:
        """Tell whether it is known to be paused."""
        return self.pause(robot) is True

    def is_fresh(self, robot: Robot, value: str) -> bool:
        """Tell whether a value, a field of Robot, has arrived and still holds: for as long as its kind
        allows, and never while the robot is offline."""
        reading: Reading[object] | None = getattr(robot, value)
        return reading is not None and self._holds(robot, value, reading)

    def _holds(self, robot: Robot, value: str, reading: Reading[object]) -> bool:
        silence = robot.kind.silence_of(value, self.limits.offline_after)
        if value == "pose" and robot.is_undated:
            return False
        return self.now - reading.at <= silence + self.behind and self.is_online(robot)

    def is_old(self, robot: Robot, value: str) -> bool:
        """Tell whether a value has arrived, and no longer holds."""
        reading: Reading[object] | None = getattr(robot, value)
        return reading is not None and not self._holds(robot, value, reading)

    def has_old(self, robot: Robot, values: Iterable[str]) -> bool:
        """Tell whether one of the values of an online robot is old."""
        silence, usual = robot.kind.silence, self._silence(robot)
        latest = self.now - self.behind
        for value in values:  # a loop, as this is asked of every robot in every tick
            reading: Reading[object] | None = getattr(robot, value)
            if reading is not None and latest - reading.at > silence.get(value, usual):
                return True
        return False

    @property
    def unacknowledged(self) -> int:
        """Return the number of unacknowledged alarms."""
        return sum(alarm.needs_acknowledgement for alarm in self.alarms)

    @property
    def shelved(self) -> int:
        """Return the number of shelved alarms."""
        return sum(alarm.stage is AlarmStage.SHELVED for alarm in self.alarms)


def with_robot(state: FleetState, robot: Robot) -> FleetState:
    """Return the state with an updated robot, and the time of its last bad data."""
    if robot.faults > state.robots[robot.name].faults:
        robot = replace(robot, fault_at=state.now)
    return replace(state, robots={**state.robots, robot.name: robot})


def returned_text(state: FleetState, link: LinkState) -> Message:
    """Return for how long a link that is up again was lost, empty if nobody saw that."""
    if link.outage <= state.limits.link_after:
        return EMPTY
    name = f"{link.name} " if len(state.links) > 1 else ""
    return Message("{name}link restored after {age}", name=name, age=age(link.outage))


MISSING_AFTER = 3.0
"""Seconds of a link after which a value that must arrive regularly is missing."""


def is_missing(state: FleetState, robot: Robot, value: str) -> bool:
    """Tell whether a value that must arrive regularly has never come, though there was time for it."""
    has_begun = state.now - state.links[robot.link].ready_since < MISSING_AFTER
    return getattr(robot, value) is None and robot.kind.expects(value) and not has_begun


def missing_text(state: FleetState, robot: Robot, value: str) -> Message:
    """Return the text of a value that was not received: `-` if none has to be."""
    if not robot.kind.expects(value):
        return Message("-")
    return (
        Message("{report} missing", report=Message(value))
        if is_missing(state, robot, value)
        else Message("no {report} yet", report=Message(value))
    )


def obstacle_text(state: FleetState, robot: Robot, contact: Reading[float]) -> Message:
    """Return `obstacle 4.2 s` while the contact lasts; afterwards in the past tense."""
    if state.is_old(robot, "obstacle"):
        return Message(
            "contact for {duration}, {age} ago",
            duration=duration(contact.value),
            age=age(state.now - contact.at),
        )
    return Message("obstacle {duration}", duration=duration(contact.value))


def behind_text(state: FleetState) -> Message:
    """Return the text of this console's delay."""
    return Message("this console is {duration} behind", duration=duration(state.behind))
