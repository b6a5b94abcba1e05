"""Pauses and resumes: the evidence in telemetry that they were carried out."""

from fleet_tui.model.commands import CommandRecord, PauseRobot, ResumeRobot, Stage, Step
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import HALF_DEAD
from fleet_tui.model.navigation import Goal
from fleet_tui.model.robot import Robot
from fleet_tui.orders.goals import active, own_ids
from fleet_tui.orders.local_queue import orders_of, waiting
from fleet_tui.situation.reported_motion import STANDS_AFTER, moves_despite_pause, stands_since
from fleet_tui.text.language import Message, joined

WAITS = frozenset({Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN})
"""Text of a pause that telemetry decides."""


def is_held(state: FleetState, robot: Robot) -> bool:
    """Tell whether it is known to be paused, nothing drives it all the same, and it stands, as far as it
    reports a speed."""
    return state.is_paused(robot) and moves_despite_pause(state, robot) is None


def own_pause_text(state: FleetState, robot: Robot) -> Message:
    """Return the pause state of a robot that does not report it, as far as this console knows."""
    if (fact := moves_despite_pause(state, robot)) is not None:
        return fact.text
    if robot.kind.holds:
        return (
            Message("stopped, goal kept here")
            if waiting(state, robot)
            else Message("stopped, no goal to keep")
        )
    return Message("paused (by us)")


def is_overtaken(state: FleetState, record: CommandRecord) -> bool:
    """Tell whether the opposite of a pause or resume was given since and took effect, as far as is known:
    later reports belong to that one."""
    opposite = ResumeRobot if isinstance(record.command, PauseRobot) else PauseRobot
    return any(
        isinstance(other.command, opposite)
        and other.command.robot == record.command.robot
        and other.issued_at > record.issued_at
        and other.stage in WAITS | {Stage.CONFIRMED, Stage.UNVERIFIABLE, Stage.LATE}
        for other in state.commands
    )


def stopped(state: FleetState, robot: Robot, record: CommandRecord) -> bool:
    """Tell whether it has reported a single place since the command, or if it reports speeds, that it stands.
    A robot may stop so soon that it reports no other one."""
    if (stands := stands_since(robot, record.issued_at)) is not None:
        return stands
    if robot.pose is None or robot.standing is None or state.is_old(robot, "pose"):
        return False
    return robot.pose.at - max(robot.standing.at, record.issued_at) >= STANDS_AFTER


def pause_seen(state: FleetState, robot: Robot, record: CommandRecord, wanted: bool) -> Step | None:
    """Return the evidence for a pause or resume. It stays on the screen, and must not read as a later
    state."""
    taken = Step(Stage.UNVERIFIABLE, state.now) if record.stage is Stage.ACCEPTED else None
    if is_overtaken(state, record):
        return taken
    if robot.kind.holds:
        return _held(state, robot, record, wanted)
    sent = record.time_of(Stage.SENT) or record.issued_at
    if robot.paused is not None:
        if robot.paused.at > sent and robot.paused.value is wanted:
            return Step(Stage.CONFIRMED, state.now, Message("by the robot"))
        return None
    if wanted and record.before.moving:
        has_stopped = stopped(state, robot, record)
        return Step(Stage.CONFIRMED, state.now, Message("the robot stopped")) if has_stopped else None
    return None if robot.says_paused else taken


def _held(state: FleetState, robot: Robot, record: CommandRecord, wanted: bool) -> Step | None:
    """Return the evidence of a held pause. One that cancels goals shows when none is active any more; one
    without an answer, when a goal was cancelled since."""
    if not wanted:
        has_left = any(
            (one.time_of(Stage.SENT) or 0.0) >= record.issued_at for one in orders_of(state, robot)
        )
        goes_on = has_left or waiting(state, robot)
        detail = Message("waiting orders continue") if goes_on else Message("no orders waiting here")
        return Step(Stage.CONFIRMED, state.now, detail)
    if record.stage is not Stage.ACCEPTED and not any(
        one.stage is Stage.CANCELLED and one.at >= record.issued_at for one in robot.gone
    ):
        return None
    if robot.orders.open or any(one.has_open_order for one in orders_of(state, robot)):
        return None
    moved = record.before.moving or (robot.motion is not None and robot.motion.value.is_moving)
    if not state.is_online(robot) or (moved and not stopped(state, robot, record)):
        return None  # another client may drive it on
    kept = any(one.order_id for one in waiting(state, robot))
    detail = Message("stopped, goal kept here") if kept else Message("stopped, no goal to keep")
    ours = own_ids(robot.goals) | {one.order_id for one in orders_of(state, robot)}
    ended = [gone for gone in robot.gone if gone.at >= record.issued_at and gone.stage is Stage.CANCELLED]
    goals = [robot.order_text(gone.order) for gone in ended if gone.order.id not in ours]
    motions = [one.value for one in robot.stopped_motions if one.at >= record.issued_at]
    if foreign := [*(goal.replace("order", "goal", 1) for goal in goals), *dict.fromkeys(motions)]:
        detail = foreign_stopped(joined(", ", foreign))
    return Step(Stage.CONFIRMED, state.now, detail)


def foreign_stopped(what: Message) -> Message:
    """Return the detail of a pause that ended what another client had asked for."""
    return Message("stopped, also another client's {what}, not resumable from here", what=what)


FOREIGN = foreign_stopped(Message("|")).partition("|")[0]
"""Begin of such a detail."""


def late_goals(state: FleetState, record: CommandRecord) -> list[Goal]:
    """Return the goals that a pause must still stop: they were first listed after it was sent."""
    robot, sent = state.robots.get(record.command.robot), record.time_of(Stage.SENT)
    if robot is None or sent is None or not robot.kind.holds or not isinstance(record.command, PauseRobot):
        return []
    if record.stage not in WAITS or is_overtaken(state, record):
        return []
    return [goal for goal in active(robot.goals) if goal.listed_since > sent and not goal.is_ending]


def instead_of_pause(state: FleetState, robot: Robot, record: CommandRecord) -> Message:
    """Return the evidence of telemetry if a pause or resume can't be seen to have been carried out."""
    wanted = isinstance(record.command, PauseRobot)
    if robot.kind.holds and not state.is_online(robot):
        return HALF_DEAD if state.links[robot.link].is_half_dead else Message("the robot is offline")
    if robot.kind.holds:
        going = [
            Message("order {id} is {state_text}", id=order.id, state_text=order.state_text)
            for order in robot.orders.open
        ]
        is_moving = wanted and record.before.moving and not stopped(state, robot, record)
        return joined(", ", going[:3]) or (
            Message("the robot was not seen to stop") if is_moving else Message("no evidence in telemetry")
        )
    if robot.paused is not None:
        return Message("the robot reported no pause") if wanted else Message("the robot reported a pause")
    if robot.says_paused:
        return Message("no message on the pause topic")
    if not wanted or not record.before.moving or is_overtaken(state, record):
        return Message("no evidence in telemetry")
    if robot.pose is None or robot.pose.at - record.issued_at < STANDS_AFTER:
        return Message("no pose received since")
    return Message("the robot kept moving")
