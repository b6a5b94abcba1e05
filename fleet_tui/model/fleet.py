"""The one picture of the world, and what in it needs a person."""

from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, field
from typing import Any

from fleet_tui.model.alarm import Alarm, Condition, Priority
from fleet_tui.model.commands import CommandRecord
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.model.robot import Reading, Robot


@dataclass(frozen=True, slots=True)
class Limits:
    """When something needs a person: seconds and per cent."""

    offline_after: float = 5.0
    obstacle_after: float = 3.0
    battery_low: float = 20.0
    battery_critical: float = 10.0
    link_after: float = 2.0
    confirm_after: float = 5.0


@dataclass(frozen=True, slots=True, eq=False)
class Floor:
    """A floor of the config. `grid` is its configured map file; `tied` is False where that is a
    plain image which lies as map_metadata says; `problem` is why it can't be shown."""

    name: str
    frame_id: str
    grid: OccupancyGrid | None = None
    tied: bool = True
    problem: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class FleetState:
    """Everything known at one instant. `now` is monotonic, `wall` Unix time, both of the last tick."""

    floors: Mapping[str, Floor]
    robots: Mapping[str, Robot]
    links: Mapping[str, LinkState]
    limits: Limits = field(default_factory=Limits)
    alarms: tuple[Alarm, ...] = ()
    commands: tuple[CommandRecord, ...] = ()
    now: float = 0.0
    wall: float = 0.0

    def is_online(self, robot: Robot) -> bool:
        """Whether it spoke within the limit."""
        return robot.heard is not None and self.now - robot.heard <= self.limits.offline_after

    def was_obstructed(self, robot: Robot) -> bool:
        """Whether by its last word it was in contact with an obstacle for longer than the limit."""
        return robot.obstacle is not None and robot.obstacle.value > self.limits.obstacle_after

    def is_obstructed(self, robot: Robot) -> bool:
        """The same, where that word is fresh."""
        return self.was_obstructed(robot) and not (robot.obstacle and self.is_old(robot.obstacle))

    def is_paused(self, robot: Robot) -> bool:
        """The robot's own fresh word where it gives one, else our accepted pause."""
        if robot.paused is None:
            return robot.paused_by_us
        return robot.paused.value and not self.is_old(robot.paused)

    def is_old(self, reading: Reading[Any]) -> bool:
        """Whether a value is older than the silence after which a robot counts as offline."""
        return self.now - reading.at > self.limits.offline_after

    @property
    def unacknowledged(self) -> int:
        """How many alarms nobody has seen."""
        return sum(not alarm.acknowledged for alarm in self.alarms)


def obstacle_text(state: FleetState, contact: Reading[float]) -> str:
    """`obstacle 4.2 s` stands only while it is true; after that it is a thing of the past."""
    if state.is_old(contact):
        return f"contact for {contact.value:.1f} s, {age(state.now - contact.at)} ago"
    return f"obstacle {contact.value:.1f} s"


def _link_conditions(state: FleetState, link: LinkState, raised: Set[tuple[str, str]]) -> Iterator[Condition]:
    was_dead = (link.name, "commands") in raised and link.phase is not Phase.UP
    if was_dead or (link.phase is Phase.UP and link.command_path is CommandPath.DEAD):
        text = f"commands don't get through: {link.command_reason}"
        yield Condition(link.name, "commands", Priority.HIGH, text, "commands get through again")
    if link.phase is not Phase.UP:
        if state.now - link.since <= state.limits.link_after:
            return
        text = f"no link: {link.reason}" if link.reason else "no link"
        yield Condition(link.name, "link", Priority.HIGH, text, "link is back")


def _robot_conditions(state: FleetState, robot: Robot, raised: Set[tuple[str, str]]) -> Iterator[Condition]:
    online = state.is_online(robot)
    link = state.links[robot.link]
    # While the link is down its own alarm stands for its robots; what was raised before goes on.
    heard_of = link.phase is Phase.UP and state.now - link.since > state.limits.offline_after
    if not online and (heard_of or (robot.name, "offline") in raised):
        text = "never seen" if robot.heard is None else f"offline {age(state.now - robot.heard)}"
        yield Condition(robot.name, "offline", Priority.MEDIUM, text, "is back")
    if robot.obstacle is not None and state.was_obstructed(robot):
        text = obstacle_text(state, robot.obstacle)
        yield Condition(robot.name, "obstacle", Priority.HIGH, text, "way is free again")
    if robot.battery is not None and robot.battery.value < state.limits.battery_low:
        critical = robot.battery.value < state.limits.battery_critical
        text = f"battery {int(robot.battery.value)} %"
        priority = Priority.MEDIUM if critical else Priority.LOW
        yield Condition(robot.name, "battery", priority, text, "battery is charged again")


def age(seconds: float) -> str:
    """A time span as an operator reads it: `4 s`, `3 min`, `2 h`."""
    seconds = max(0.0, seconds)
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.0f} h"


def conditions(state: FleetState) -> Iterator[Condition]:
    """Everything that needs a person now."""
    raised = {alarm.key for alarm in state.alarms if alarm.active}
    for link in state.links.values():
        yield from _link_conditions(state, link, raised)
    for robot in state.robots.values():
        yield from _robot_conditions(state, robot, raised)
