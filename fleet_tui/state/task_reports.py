"""Reports of tasks: the effect of each on the queues of all robots."""

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.fleets.events import TaskReported
from fleet_tui.model.navigation import Goal, Progress
from fleet_tui.model.order import OVER, OrderState
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.rules.commands.goals import active, with_reported, without
from fleet_tui.state.goal_reports import with_queue

TASK = "task"
ENDED_FOR = 60.0
"""Seconds for which an ended task is kept, for the command that gave it."""


def apply_task(state: FleetState, event: TaskReported) -> FleetState:
    """Return the state after a report on a task: of its robot, and of one that had it before."""
    for robot in state.robots.values():
        if robot.name != event.robot and any(one.uuid == event.task.uuid for one in _tasks(robot)):
            state = with_robot(_moved(state, robot.name, event), _without(robot, event))
    robot_now = state.robots.get(event.robot)
    if robot_now is None or not _is_news(state, robot_now, event.task):
        return state
    return with_robot(state, _with_task(robot_now, event))


def _tasks(robot: Robot) -> tuple[Goal, ...]:
    return robot.goals.get(TASK, ())


def _is_news(state: FleetState, robot: Robot, task: Goal) -> bool:
    """Tell whether a task matters: one that had ended before it was first seen does only if this console
    gave it."""
    if task.state not in OVER or any(one.uuid == task.uuid for one in _tasks(robot)):
        return True
    return any(one.name and one.name in (task.uuid, task.requester) for one in state.commands)


def _without(robot: Robot, event: TaskReported) -> Robot:
    """Return a robot without a task that is another one's now: it neither ended nor was lost."""
    traces = {id_: trace for id_, trace in robot.traces.items() if id_ != event.task.id}
    robot = replace(robot, goals=without(robot.goals, {event.task.uuid}), traces=traces)
    return with_queue(robot, event.at)


def _moved(state: FleetState, before: str, event: TaskReported) -> FleetState:
    """Return the state with this console's order at the robot that has it now."""
    if event.robot not in state.robots:
        return state
    commands = tuple(
        replace(one, command=replace(one.command, robot=event.robot))
        if one.command.robot == before and one.order_id == event.task.id
        else one
        for one in state.commands
    )
    return replace(state, commands=commands)


def _with_task(robot: Robot, event: TaskReported) -> Robot:
    at, last = event.at, robot.orders.last_serial
    goals = with_reported(robot.goals, TASK, (event.task,), at, last, is_whole=False)
    kept = (one for one in goals[TASK] if one.ended_at is None or at - one.ended_at < ENDED_FOR)
    goals = {**goals, TASK: tuple(kept)}
    is_named = robot.named != "" and robot.named in (event.task.uuid, event.task.requester)
    robot = with_queue(replace(robot, goals=goals, named="" if is_named else robot.named), at)
    held = any(one.state is OrderState.PAUSED for one in active(robot.goals))
    progress = robot.progress
    if event.seconds is not None and event.task.state not in OVER:
        progress = Reading(Progress(event.task.id, seconds=event.seconds), at)
    return replace(robot, paused=Reading(held, at), progress=progress)
