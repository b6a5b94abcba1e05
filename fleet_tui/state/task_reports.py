"""Reports of tasks: the effect of each on the queues of all robots."""

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.fleets.events import TaskReported
from fleet_tui.model.fleets.member import Member
from fleet_tui.model.navigation import Goal, Progress
from fleet_tui.model.order import OVER, OrderState
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.orders.goals import active, with_reported, without
from fleet_tui.state.goal_reports import with_queue

TASK = "task"
FRESH = 5.0
"""Seconds for which the report of a fleet adapter holds."""
BEGUN_LOST = 60.0
WAITING_LOST = 3600.0
"""Seconds without a report after which a task that a robot had begun, or that waits for one, is lost if the
robot drives another, or none. One may wait for its hour."""
AT_REST = frozenset({"idle", "charging"})
UNREPORTED = "no longer reported: unknown whether it was done"
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


def without_unreported(robot: Robot, now: float) -> Robot:
    """Return a robot whose tasks are lost that its fleet adapter does not know any more: their end, or the
    robot that has them now, was not reported. Nothing tells that they were carried out."""
    member = robot.member
    if member is None or now - member.at > FRESH:
        return robot
    lost = {one.uuid for one in active(robot.goals) if _is_unreported(one, member.value, now)}
    if not lost:
        return robot
    goals = {
        action: tuple(
            replace(one, state=OrderState.LOST, ended_at=now, said=UNREPORTED) if one.uuid in lost else one
            for one in listed
        )
        for action, listed in robot.goals.items()
    }
    robot = with_queue(replace(robot, goals=goals), now)
    held = any(one.state is OrderState.PAUSED for one in active(goals))
    return replace(robot, paused=Reading(held, now))


def _is_unreported(task: Goal, member: Member, now: float) -> bool:
    """Tell whether a robot drives another task, or none, for longer than the report of an end takes."""
    if member.task == task.uuid or task.action != TASK:
        return False
    if not member.task and member.mode not in AT_REST and member.status != "idle":
        return False
    waits = WAITING_LOST if task.state is OrderState.QUEUED else BEGUN_LOST
    return now - task.listed_at > waits


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
