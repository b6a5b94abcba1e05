"""Reports of robots: the effect of each on its robot."""

import math
from functools import partial
from typing import NamedTuple, assert_never

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Order, OrderQueue, vertices_of
from fleet_tui.model.order_life import corrected, trace_movement, trace_queue
from fleet_tui.model.robot import Reading, Robot, RobotMap, StampClock, with_fault
from fleet_tui.situation.movement import JUMPS_WITHIN, jump, moved, progressed
from fleet_tui.situation.movement import pace as new_pace
from fleet_tui.situation.pose_checks.jumps import pose_jump
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_NAME, MOST_ORDERS, truncate

# A robot whose clock runs slower than ours by this share must not age into "offline" over days.
CLOCK_DRIFT = 1e-3
# Seconds by which a robot's clock may be ahead of that of its site.
CLOCK_AHEAD = 5.0
# Stamps of one robot never go backwards unless its clock was set.
CLOCK_STEP = 0.5
# Seconds beyond the lateness of a bridge by which a clock that agrees with its site's may seem to be off.
LATE_TOLERANCE = 1.0
# Seconds from one message to the next from which they are no stream: one of them may be latched.
STREAM_GAP = 5.0
# Seconds by which times differ that are the same.
ROUNDING = 1e-3
# A robot brakes after it accepted a pause; further than this, it drives.
BRAKING_DISTANCE = 0.5
JUMPS_KEPT = 100
# Ended orders are kept for the commands that placed them, which are checked ten times a second.
GONE_FOR = 60.0
GONE_KEPT = 2 * MOST_ORDERS
TRACES_KEPT = 2 * MOST_ORDERS


class SiteClock(NamedTuple):
    """The clock of a site: `offset` is (arrival - stamp) of a message that is sent now, `late` the seconds by
    which its bridge is late, `drifted` those that it has lost against ours by its pace."""

    offset: float
    late: float = 0.0
    drifted: float = 0.0


def set_clock(clock: StampClock | None, at: float, stamp: float, site: SiteClock | None = None) -> StampClock:
    """Compare a robot's clock with ours, by a message of `stamp` that arrived `at`. Its first one may be
    latched, and is compared with the clock of its site; once its clock runs, that itself is trusted: it may
    be hours off, but not run slower than that of its site."""
    last = None if clock is None else clock.site
    return replace(_set_clock(clock, at, stamp, site), site=last if site is None else site.drifted)


def _set_clock(clock: StampClock | None, at: float, stamp: float, site: SiteClock | None) -> StampClock:
    offset = at - stamp
    if clock is None:
        known = offset if site is None else min(offset, site.offset)
        # Ahead of its site a robot's clock is another one, which tells no age.
        is_ahead = site is not None and math.isfinite(site.offset) and offset < site.offset - CLOCK_AHEAD
        is_compared = site is not None and not is_ahead
        return StampClock(known, stamp, at, is_running=False, is_compared=is_compared)
    if stamp < clock.stamp - CLOCK_STEP:
        return StampClock(offset, stamp, at)
    if not clock.is_running:
        return _started(clock, at, stamp, site)
    drifted = 0.0 if site is None or clock.site is None else site.drifted - clock.site
    crept = clock.offset + max(CLOCK_DRIFT * max(0.0, at - clock.at), drifted)
    return StampClock(min(crept, offset), stamp, at)


def _started(clock: StampClock, at: float, stamp: float, site: SiteClock | None) -> StampClock:
    """Return the clock after a further message: it runs if that has another stamp."""
    offset = at - stamp
    if stamp == clock.stamp:
        return StampClock(clock.offset, stamp, at, is_running=False)
    is_late = site is not None and site.late > 0.0 and offset - site.offset <= site.late + LATE_TOLERANCE
    if _is_live(clock, at, stamp) and not is_late:
        return StampClock(min(clock.at - clock.stamp, offset), stamp, at)
    # A backlog: the clock of its site still tells how old it is.
    offset = min(clock.offset, offset)
    return StampClock(offset, stamp, at, is_running=is_late or at - stamp - offset < CLOCK_STEP)


def _is_live(clock: StampClock, at: float, stamp: float) -> bool:
    """Tell whether a message comes as it is sent, after the last one that set the clock, however old its
    stamp: a lone one may be latched, and stamps run faster than arrivals while a backlog is read."""
    since = at - clock.at
    return since <= STREAM_GAP and 0.0 <= stamp - clock.stamp <= since + ROUNDING


def _place(robot: Robot, pose: Reading[Pose], frame_id: str) -> Reading[Pose]:
    before = robot.place
    if before is None or frame_id != robot.frame_id:
        return pose
    return pose if progressed(before.value, pose.value) else before


def _jumps(robot: Robot, pose: Pose, frame_id: str, at: float) -> tuple[Reading[float], ...]:
    last = robot.pose
    if last is None or frame_id != robot.frame_id:
        return robot.jumps
    metres = jump(last.value, pose, at - last.at)
    if metres is None:
        return robot.jumps
    recent = (jump for jump in robot.jumps if at - jump.at < JUMPS_WITHIN)
    return (*recent, Reading(metres, at))[-JUMPS_KEPT:]


def relocation(robot: Robot, pose: Pose, frame_id: str, at: float) -> Reading[Message] | None:
    """Return the last jump of a robot's pose that its speed can't explain."""
    last = robot.pose
    if last is None or frame_id != robot.frame_id:
        return robot.relocated
    text = pose_jump(last.value, pose, at - last.at)
    return Reading(text, at) if text else robot.relocated


def _pace(robot: Robot, pose: Pose, frame_id: str, at: float) -> float | None:
    last = robot.pose
    if last is None or frame_id != robot.frame_id:
        return robot.pace
    return new_pace(robot.pace, last.value, pose, at - last.at)


def _drives_on(robot: Robot, pose: Pose) -> bool:
    """Tell whether it moves despite our pause. If the pause is only that this console holds back the next
    goal, it lasts however the robot is moved."""
    at = robot.paused_at
    if at is None or robot.kind.holds:
        return False
    return math.dist((pose.x, pose.y), (at.x, at.y)) > BRAKING_DISTANCE


def _standing(robot: Robot, pose: Reading[Pose], frame_id: str) -> Reading[Pose]:
    standing = robot.standing
    if standing is not None and frame_id != robot.frame_id and not robot.kind.frames_are_floors:
        # Odometry gave way to localisation, or back: to be placed elsewhere is no movement.
        return Reading(pose.value, standing.at)
    if standing is None or frame_id != robot.frame_id or moved(standing.value, pose.value):
        return pose
    return standing


def clocked(
    robot: Robot, at: float, stamp: float | None, site: SiteClock | None
) -> tuple[StampClock | None, float, float | None]:
    """Return a robot's clock after a message, the second at which the message was true, and the one at which
    its robot spoke, None if that is unknown."""
    before = robot.clock
    if stamp is None:
        return before, at, at
    clock = set_clock(before, at, stamp, site)
    # For an extreme stamp the sum is off by minutes: no value is newer than its arrival.
    true_at = min(at, stamp + clock.offset)
    if before is not None and _is_live(before, at, stamp):
        return clock, true_at, at
    return clock, true_at, true_at if clock.is_compared else None


def latest(last: float | None, spoke_at: float | None) -> float | None:
    """Return when a robot spoke last, after a message of which that may be unknown."""
    return last if spoke_at is None else max(last or spoke_at, spoke_at)


def _take_pose(robot: Robot, event: events.PoseReported, site: SiteClock | None) -> Robot:
    """Apply a pose, as old as its stamp lags the freshest: one that arrives late must not look new. Its
    robot speaks now if it is one of a live stream."""
    clock, true_at, spoke_at = clocked(robot, event.at, event.stamp, site)
    pose, frame_id = Reading(event.pose, true_at), truncate(event.frame_id.lstrip("/"), LONGEST_NAME)
    driving = _drives_on(robot, event.pose)
    stood_at = robot.paused_at or (event.pose if robot.paused_by_us else None)
    robot = replace(
        robot,
        pose=pose,
        is_estimated=False,
        standing=_standing(robot, pose, frame_id),
        place=_place(robot, pose, frame_id),
        jumps=_jumps(robot, event.pose, frame_id, true_at),
        relocated=relocation(robot, event.pose, frame_id, true_at),
        misplaced=robot.misplaced if frame_id == robot.frame_id else None,  # may be another floor
        pace=_pace(robot, event.pose, frame_id, true_at),
        frame_id=frame_id,
        clock=clock,
        last_received=latest(robot.last_received, spoke_at),
        paused_by_us=robot.paused_by_us and not driving,
        paused_at=None if driving else stood_at,
    )
    traces = trace_movement(robot.traces, partial(_metres_to_end, robot))
    return robot if traces is robot.traces else replace(robot, traces=traces)


def lost_vertices(robot: Robot, queue: OrderQueue) -> list[Message]:
    """Return one line for each order of the queue that names a vertex missing from every graph of the
    robot. The nodes of a vehicle are its master control's: its graph need not be ours."""
    if robot.vehicle is not None or not robot.knows_all_graphs():
        return []
    return [
        Message("order {id} names unknown vertex {vertex}", id=order.id, vertex=vertex)
        for order in queue.orders
        for vertex in vertices_of(order.stops)
        if robot.name_of(vertex) is None
    ]


def _metres_to_end(robot: Robot, order: Order) -> tuple[float, float] | None:
    robot_map, end = robot.maps.get(robot.floor or ""), order.end
    graph = robot_map.graph if robot_map else None
    if robot.pose is None or end is None or (end.pose is None and graph is None):
        return None
    # Like the queue's, the arrival time: a bridge may be late with both.
    at = max(robot.pose.at, robot.clock.at if robot.clock else robot.pose.at)
    place = end.pose or (graph.vertices.get(end.vertex) if graph else None)
    if place is None:
        return math.inf, at
    return math.dist((robot.pose.value.x, robot.pose.value.y), (place.x, place.y)), at


def _without_lost_pause(robot: Robot, event: events.QueueReported) -> Robot:
    """Drop the pause of a robot whose order count restarted: the robot was restarted, so no earlier request
    holds."""
    if not robot.paused_by_us or event.queue.last_serial >= robot.orders.last_serial:
        return robot
    return replace(robot, paused_by_us=False, paused_at=None, pause_lost_at=event.at)


def _apply_queue(robot: Robot, event: events.QueueReported) -> Robot:
    """Apply a queue. An order to an unknown vertex is counted once, when it first appears."""
    queue, at = event.queue, event.at
    before = set(lost_vertices(robot, robot.orders))
    for line in lost_vertices(robot, queue):
        if line not in before:
            robot = with_fault(robot, line)
    last = (robot.queue.at, robot.orders.last_serial) if robot.queue else None
    traces, gone = trace_queue(
        robot.traces, queue, at, last, partial(_metres_to_end, robot), robot.kind.reports_ends
    )
    robot = replace(_without_lost_pause(robot, event), queue=Reading(queue, at))
    if event.fault:
        # Orders were dropped from it: whether the others are gone is unknown.
        older = {id_: trace for id_, trace in robot.traces.items() if id_ not in traces}
        kept = list((older | dict(traces)).items())[-TRACES_KEPT:]
        return with_fault(replace(robot, traces=dict(kept)), event.fault)
    left = corrected(robot.gone, queue, robot.kind.reports_ends)
    recent = (one for one in left if at - one.at < GONE_FOR) if gone else left
    return replace(robot, traces=traces, gone=(*recent, *gone)[-GONE_KEPT:])


def _take_battery(robot: Robot, event: events.BatteryReported) -> Robot:
    """Apply a charge. The first value above 1 shows, permanently, that a robot of unknown scale counts in per
    cent."""
    percent, counts_percent = event.percent, robot.counts_percent
    if event.is_raw:
        counts_percent = counts_percent or percent > 1.0
        percent = percent if counts_percent else percent * 100.0
    return replace(robot, battery=Reading(percent, event.at), counts_percent=counts_percent)


def apply_report(robot: Robot, event: events.Telemetry, site: SiteClock | None = None) -> Robot:
    """Apply one report of a robot to it; `site` dates the stamp of its first one."""
    match event:
        case events.PoseReported():
            return _take_pose(robot, event, site)
        case events.BatteryReported():
            robot = _take_battery(robot, event)
        case events.CargoReported():
            robot = replace(robot, cargo=Reading(event.loaded, event.at))
        case events.ObstacleReported():
            robot = replace(robot, obstacle=Reading(event.seconds, event.at))
        case events.QueueReported():
            robot = _apply_queue(robot, event)
        case events.PausedReported():
            robot = replace(robot, paused=Reading(event.paused, event.at))
        case _:
            assert_never(event)
    return replace(robot, last_received=max(robot.last_received or event.at, event.at))


def apply_map_fact(robot: Robot, event: events.MapFactReceived) -> Robot:
    """Apply a robot's report about a floor to it."""
    robot_map = robot.maps.get(event.floor, RobotMap())
    match event:
        case events.FrameReceived():
            robot_map = replace(robot_map, frame=event.frame)
        case events.GraphReceived():
            robot_map = replace(robot_map, graph=event.graph)
        case events.LabelsReceived():
            robot_map = replace(robot_map, labels=dict(event.labels))
        case events.GridReceived():
            robot_map = replace(robot_map, grid=event.grid, grid_at=event.at)
        case _:
            assert_never(event)
    before = set(lost_vertices(robot, robot.orders))
    robot = replace(robot, maps={**robot.maps, event.floor: robot_map})
    if isinstance(event, events.GraphReceived | events.LabelsReceived) and event.faults:
        robot = with_fault(robot, event.fault, event.faults)
    for line in lost_vertices(robot, robot.orders):
        if line not in before:
            robot = with_fault(robot, line)
    return robot
