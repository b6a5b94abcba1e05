"""The one picture of the world, and how each fact turns it into the next."""

from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, field, replace
from typing import assert_never

from fleet_tui.model import events
from fleet_tui.model.alarm import Alarm, Condition, Priority, acknowledge, ripen
from fleet_tui.model.commands import Command, CommandRecord, Outcome, PauseRobot, ResumeRobot
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.model.occupancy import OccupancyGrid
from fleet_tui.model.robot import Robot, hear, take_chart, with_fault

COMMANDS_KEPT = 200


@dataclass(frozen=True, slots=True)
class Limits:
    """When something needs a person: seconds and per cent."""

    offline_after: float = 5.0
    obstacle_after: float = 3.0
    battery_low: float = 20.0
    battery_critical: float = 10.0
    link_after: float = 2.0


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

    def is_obstructed(self, robot: Robot) -> bool:
        """Whether it has been in contact with an obstacle for longer than the limit."""
        return robot.obstacle is not None and robot.obstacle.value > self.limits.obstacle_after

    @property
    def unacknowledged(self) -> int:
        """How many alarms nobody has seen."""
        return sum(not alarm.acknowledged for alarm in self.alarms)


def is_paused(robot: Robot) -> bool:
    """The robot's own word where it gives one, else our accepted pause."""
    return robot.paused.value if robot.paused is not None else robot.paused_by_us


def _link_conditions(state: FleetState, link: LinkState) -> Iterator[Condition]:
    if link.phase is not Phase.UP:
        if state.now - link.since <= state.limits.link_after:
            return
        text = f"no link: {link.reason}" if link.reason else "no link"
        yield Condition(link.name, "link", Priority.HIGH, text, "link is back")
    elif link.command_path is CommandPath.DEAD:
        text = f"commands don't get through: {link.command_reason}"
        yield Condition(link.name, "commands", Priority.HIGH, text, "commands get through again")


def _robot_conditions(state: FleetState, robot: Robot, raised: Set[tuple[str, str]]) -> Iterator[Condition]:
    online = state.is_online(robot)
    link = state.links[robot.link]
    # While the link is down its own alarm stands for its robots; what was raised before goes on.
    heard_of = link.phase is Phase.UP and state.now - link.since > state.limits.offline_after
    if not online and (heard_of or (robot.name, "offline") in raised):
        text = "never seen" if robot.heard is None else f"offline {age(state.now - robot.heard)}"
        yield Condition(robot.name, "offline", Priority.MEDIUM, text, "is back")
    if robot.obstacle is not None and state.is_obstructed(robot):
        text = f"obstacle {robot.obstacle.value:.1f} s"
        if not online:
            text += f", {age(state.now - robot.obstacle.at)} ago"
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


def _pass_time(state: FleetState, event: events.TimePassed) -> FleetState:
    state = replace(state, now=event.at, wall=event.wall)
    raised = {alarm.key for alarm in state.alarms if alarm.active}
    conditions = [found for link in state.links.values() for found in _link_conditions(state, link)]
    conditions += [
        found for robot in state.robots.values() for found in _robot_conditions(state, robot, raised)
    ]
    return replace(state, alarms=ripen(state.alarms, conditions, event.at, event.wall))


def _with_robot(state: FleetState, robot: Robot) -> FleetState:
    return replace(state, robots={**state.robots, robot.name: robot})


def _with_link(state: FleetState, link: LinkState) -> FleetState:
    return replace(state, links={**state.links, link.name: link})


def _change_link(state: FleetState, event: events.LinkChanged) -> FleetState:
    """While it is tried again and again, `since` stays the moment of the loss."""
    link = state.links[event.link]
    same_side = (link.phase is Phase.UP) == (event.phase is Phase.UP)
    return _with_link(
        state,
        replace(
            link,
            phase=event.phase,
            reason=event.reason or (link.reason if event.phase is not Phase.UP else ""),
            next_try=event.next_try,
            since=link.since if same_side and link.since else event.at,
        ),
    )


def _after_command(robot: Robot, command: Command, outcome: Outcome) -> Robot:
    """Our own accepted pause is all that is known where no topic tells it."""
    if outcome is not Outcome.ACCEPTED:
        return robot
    match command:
        case PauseRobot():
            return replace(robot, paused_by_us=True, paused_at=robot.pose.value if robot.pose else None)
        case ResumeRobot():
            return replace(robot, paused_by_us=False, paused_at=None)
    return robot


def _finish_command(state: FleetState, event: events.CommandFinished) -> FleetState:
    """A command ends once: whatever else comes for it changes nothing."""
    found = next((record for record in state.commands if record.id == event.id), None)
    if found is None or found.outcome is not None:
        return state
    ended = replace(found, outcome=event.outcome, words=event.words)
    commands = tuple(ended if record is found else record for record in state.commands)
    robot = state.robots.get(found.command.robot)
    if robot is not None:
        state = _with_robot(state, _after_command(robot, found.command, event.outcome))
    return replace(state, commands=commands)


def _apply_to_robot(
    state: FleetState, event: events.Telemetry | events.ChartReceived | events.MessageRejected
) -> FleetState:
    robot = state.robots.get(event.robot)
    if robot is None:
        return state
    match event:
        case events.MessageRejected():
            return _with_robot(state, with_fault(robot, event.text))
        case (
            events.FrameReceived() | events.GraphReceived() | events.LabelsReceived() | events.GridReceived()
        ):
            return _with_robot(state, take_chart(robot, event))
        case events.PoseReported():
            robot = hear(robot, event)
            return _with_robot(state, replace(robot, floor=_floor_with(state, robot.frame_id)))
        case _:
            return _with_robot(state, hear(robot, event))


def _floor_with(state: FleetState, frame_id: str) -> str | None:
    return next((floor.name for floor in state.floors.values() if floor.frame_id == frame_id), None)


def _apply_to_link(
    state: FleetState,
    event: events.LinkChanged | events.LinkHeard | events.CommandPathChanged | events.FrameRejected,
) -> FleetState:
    if isinstance(event, events.LinkChanged):
        return _change_link(state, event)
    link = state.links[event.link]
    match event:
        case events.LinkHeard():
            return _with_link(state, replace(link, heard=event.at))
        case events.CommandPathChanged():
            return _with_link(state, replace(link, command_path=event.path, command_reason=event.reason))
        case events.FrameRejected():
            return _with_link(state, replace(link, faults=link.faults + 1, last_fault=event.text))
        case _:
            assert_never(event)


def _issue_command(state: FleetState, event: events.CommandIssued) -> FleetState:
    record = CommandRecord(event.id, event.command, event.at, event.wall)
    return replace(state, commands=(*state.commands, record)[-COMMANDS_KEPT:])


def _load_floor_map(state: FleetState, event: events.FloorMapLoaded) -> FleetState:
    floor = replace(state.floors[event.floor], grid=event.grid, problem=event.problem, tied=event.tied)
    return replace(state, floors={**state.floors, floor.name: floor})


def apply(state: FleetState, event: events.Event) -> FleetState:
    """The state after one fact."""
    match event:
        case events.TimePassed():
            return _pass_time(state, event)
        case events.LinkChanged() | events.LinkHeard() | events.CommandPathChanged() | events.FrameRejected():
            return _apply_to_link(state, event)
        case events.CommandIssued():
            return _issue_command(state, event)
        case events.CommandFinished():
            return _finish_command(state, event)
        case events.AlarmAcknowledged():
            return replace(state, alarms=acknowledge(state.alarms, event.source, event.kind))
        case events.FloorMapLoaded():
            return _load_floor_map(state, event)
        case _:
            return _apply_to_robot(state, event)
