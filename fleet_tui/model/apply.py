"""How each fact turns the picture of the world into the next one."""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.alarm import Alarm, acknowledge, ripen, shelve, unshelve
from fleet_tui.model.bounds import brief
from fleet_tui.model.commands import (
    Before,
    CancelOrder,
    ClearOrders,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
    Step,
)
from fleet_tui.model.conditions import conditions
from fleet_tui.model.confirmation import before, confirm
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.floods import without_floods
from fleet_tui.model.floor_events import apply_to_floor
from fleet_tui.model.follow_up import follow_up
from fleet_tui.model.lag import with_lags
from fleet_tui.model.link_events import apply_to_link
from fleet_tui.model.reports import apply_chart, apply_report
from fleet_tui.model.robot import Robot, with_fault

COMMANDS_KEPT = 200
LIVE_MAPS_KEPT, LIVE_CELLS_KEPT = 4, 16_000_000
"""Live maps, and their cells: one robot's map is looked at, and asked for again when another's was."""


def _pass_time(state: FleetState, event: events.TimePassed) -> FleetState:
    state = with_lags(replace(state, now=event.at, wall=event.wall), event.at, event.behind)
    state = _confirm_commands(state)
    held = {alarm.key: alarm.condition for alarm in state.alarms if alarm.holds}
    found = list(conditions(state, held))
    began = {one.key: state.began.get(one.key, event.at) for one in found}
    due = without_floods(state, found, held)
    alarms = ripen(state.alarms, due, event.at, event.wall, state.limits.clear_after)
    return replace(state, began=began, alarms=alarms)


def _with_robot(state: FleetState, robot: Robot) -> FleetState:
    if robot.faults > state.robots[robot.name].faults:
        robot = replace(robot, fault_at=state.now)
    return replace(state, robots={**state.robots, robot.name: robot})


def _confirm_commands(state: FleetState) -> FleetState:
    """One after the other: an order in a queue is the doing of one command only."""
    for record in state.commands:
        looked = follow_up(state, record) if record.is_decided else confirm(state, record)
        if looked is not record:
            state = _after_step(_with_record(state, looked), looked)
    return state


def _with_record(state: FleetState, record: CommandRecord) -> FleetState:
    commands = tuple(record if one.id == record.id else one for one in state.commands)
    return replace(state, commands=commands)


def _after_step(state: FleetState, record: CommandRecord) -> FleetState:
    """Note our own pause: where no topic tells it, that is all that is known."""
    robot = state.robots.get(record.command.robot)
    if robot is None or record.stage not in (Stage.ACCEPTED, Stage.CONFIRMED, Stage.LATE):
        return state
    match record.command:
        case PauseRobot():
            stands_at = robot.pose.value if robot.pose else None
            return _with_robot(state, replace(robot, paused_by_us=True, paused_at=stands_at))
        case ResumeRobot():
            return _with_robot(state, replace(robot, paused_by_us=False, paused_at=None))
        case PlaceOrder() | CancelOrder() | ClearOrders():
            return state
        case _:
            assert_never(record.command)


def _advance_command(state: FleetState, event: events.CommandAdvanced) -> FleetState:
    """A command ends once: whatever else comes for it changes nothing."""
    found = next((record for record in state.commands if record.id == event.id), None)
    if found is None:
        return state
    record = found.advanced(Step(_late_or(event.stage, state, found), event.at, brief(event.words)))
    return state if record is found else _after_step(_with_record(state, record), record)


def _late_or(stage: Stage, state: FleetState, record: CommandRecord) -> Stage:
    """The stage that an answer leads to. Where no topic tells a pause, an answer long after the command is
    the only sign that it was carried out."""
    robot = state.robots.get(record.command.robot)
    late = stage is Stage.ACCEPTED and record.stage is Stage.NOT_CONFIRMED
    untold = robot is not None and not robot.says_paused
    return Stage.LATE if late and untold and isinstance(record.command, PauseRobot | ResumeRobot) else stage


def _forget_grids(state: FleetState, event: events.GridReceived) -> FleetState:
    """Of the other live maps none is kept where all would be too much."""
    grids = [chart.grid for robot in state.robots.values() for chart in robot.charts.values() if chart.grid]
    cells = sum(grid.frame.width * grid.frame.height for grid in [event.grid, *grids])
    if cells <= LIVE_CELLS_KEPT and len(grids) < LIVE_MAPS_KEPT:
        return state
    robots = {
        name: replace(
            robot, charts={floor: replace(chart, grid=None) for floor, chart in robot.charts.items()}
        )
        for name, robot in state.robots.items()
    }
    return replace(state, robots=robots)


def _shared(state: FleetState, event: events.GraphReceived) -> events.GraphReceived:
    """With the graph that another robot has, if it is the same: one serves all, and what is made of it."""
    for robot in state.robots.values():
        chart = robot.charts.get(event.floor)
        if chart is not None and chart.graph == event.graph:
            return replace(event, graph=chart.graph)
    return event


def _apply_to_robot(
    state: FleetState, event: events.Telemetry | events.ChartReceived | events.MessageRejected
) -> FleetState:
    robot = state.robots.get(event.robot)
    if robot is None:
        return state
    match event:
        case events.MessageRejected():
            return _with_robot(state, with_fault(robot, event.text))
        case events.GraphReceived():
            return _with_robot(state, apply_chart(robot, _shared(state, event)))
        case events.FrameReceived() | events.LabelsReceived():
            return _with_robot(state, apply_chart(robot, event))
        case events.GridReceived():
            state = _forget_grids(state, event)
            return _with_robot(state, apply_chart(state.robots[event.robot], event))
        case events.PoseReported():
            robot = apply_report(robot, event)
            return _with_robot(state, replace(robot, floor=_floor_with(state, robot.frame_id)))
        case (
            events.BatteryReported()
            | events.CargoReported()
            | events.ObstacleReported()
            | events.QueueReported()
            | events.PausedReported()
        ):
            return _with_robot(state, apply_report(robot, event))
        case _:
            assert_never(event)


def _floor_with(state: FleetState, frame_id: str) -> str | None:
    return next((floor.name for floor in state.floors.values() if floor.frame_id == frame_id), None)


def _is_in_queue(state: FleetState, record: CommandRecord) -> bool:
    """Whether the order it placed is still there: who gave it must be known as long."""
    robot = state.robots.get(record.command.robot)
    return robot is not None and any(order.id == record.order_id for order in robot.orders.orders)


def _issue_command(state: FleetState, event: events.CommandIssued) -> FleetState:
    if any(record.id == event.id for record in state.commands):
        return state
    robot = state.robots.get(event.command.robot)
    record = CommandRecord(
        event.id,
        event.command,
        event.at,
        event.wall,
        (Step(Stage.CHECKED, event.at),),
        Before() if robot is None else before(robot, event.at),
    )
    commands = (*state.commands, record)
    # What is under way, or in a queue, stays, however much there is.
    surplus = len(commands) - COMMANDS_KEPT
    if surplus > 0:
        old = [one.id for one in commands if one.is_decided and not _is_in_queue(state, one)][:surplus]
        commands = tuple(one for one in commands if one.id not in old)
    return replace(state, commands=commands)


def _after_operator(
    alarms: tuple[Alarm, ...], event: events.AlarmAcknowledged | events.AlarmShelved | events.AlarmUnshelved
) -> tuple[Alarm, ...]:
    match event:
        case events.AlarmAcknowledged():
            return acknowledge(alarms, event.source, event.kind)
        case events.AlarmShelved():
            return shelve(alarms, (event.source, event.kind), event.until)
        case events.AlarmUnshelved():
            return unshelve(alarms, (event.source, event.kind))
        case _:
            assert_never(event)


def apply(state: FleetState, event: events.Event) -> FleetState:
    """The state after one fact."""
    match event:
        case events.TimePassed():
            return _pass_time(state, event)
        case (
            events.LinkChanged()
            | events.LinkHeard()
            | events.CommandPathChanged()
            | events.MessagesUnsourced()
            | events.FrameRejected()
        ):
            return apply_to_link(state, event)
        case events.CommandIssued():
            return _issue_command(state, event)
        case events.CommandAdvanced():
            return _advance_command(state, event)
        case events.AlarmAcknowledged() | events.AlarmShelved() | events.AlarmUnshelved():
            return replace(state, alarms=_after_operator(state.alarms, event))
        case events.FloorMapLoaded() | events.FloorGraphLoaded():
            return apply_to_floor(state, event)
        case _:
            # Does not type-check with a new kind of fact that is about no robot.
            return _apply_to_robot(state, event)
