"""Reasons why a robot stands still, the likeliest first.

The strongest is first, and among equals the sequence of RULES decides:

CERTAIN: the robot's own fresh word, or a fact about the link. A lost connection precedes its last reports; a
pause before an obstacle, since a paused robot would not drive on a free way either; a command that failed
before the empty queue it left behind.
LIKELY: follows from several fresh reports (a place, a queue and a charge), none of which states it alone; or
an error that the robot reports about itself, which need not be what holds it.
POSSIBLE: would explain it, and so would much else; and all reports of a robot that is offline.

What is only the consequence comes last while an alarm of the robot holds that is not low:
that tells what is wrong.
A robot that moves has no reason to stand. Without any evidence, the order that it should drive is named.
"""

from collections.abc import Sequence
from operator import attrgetter
from typing import TYPE_CHECKING

from msgspec.structs import replace

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.facts import UNLOCALISED
from fleet_tui.situation.why.complaints import Complaint
from fleet_tui.situation.why.members import MEMBER_REASONS
from fleet_tui.situation.why.navigation import NAVIGATION_REASONS, estimated, not_active, still_driving
from fleet_tui.situation.why.orders import (
    at_stop,
    cargo,
    command,
    failed_order,
    no_orders,
    none_current,
    stale_queue,
    unexplained,
    waits_behind,
    waits_mutually,
)
from fleet_tui.situation.why.reason import Reason, Rule, Strength
from fleet_tui.situation.why.robot import (
    battery,
    charges,
    jumps,
    late_link,
    misplaced,
    moves,
    no_link,
    not_stopped,
    obstacle,
    off_graph,
    own_late_pause,
    paused,
    silent_robot,
    stale_pose,
    to_place,
    unreachable,
    unread,
)
from fleet_tui.text.language import Message

if TYPE_CHECKING:  # numpy
    from fleet_tui.situation.pose_checks.match import Match

from collections.abc import Callable
from functools import partial

from fleet_tui.situation.fact import Fact
from fleet_tui.situation.reported_motion import action_text, running_action
from fleet_tui.situation.vehicles import FINDERS, REPORTED
from fleet_tui.situation.why.reason import reason_of


def _told(find: Callable[[Robot], Fact | None], state: FleetState, robot: Robot) -> Reason | None:
    fact = find(robot) if state.is_fresh(robot, "vehicle") else None
    if fact is None:
        return None
    return reason_of(fact, Strength.CERTAIN if fact.is_certain else Strength.POSSIBLE)


def acts(state: FleetState, robot: Robot) -> Reason | None:
    """Report the action of its order that it carries out where it stands."""
    action = running_action(state, robot)
    if action is None or robot.vehicle is None:
        return None
    text = action_text(state, action)
    return Reason(text, REPORTED, since=action.since, seen=robot.vehicle.at)


VEHICLE_REASONS: tuple[Rule, ...] = (*(partial(_told, find) for find in FINDERS), acts)


DEAF: tuple[Rule, ...] = (no_link, silent_robot, late_link)
"""If one of these holds, everything else is an earlier report. Silence for longer than the bridge is late
is the robot's."""

ASTRAY: tuple[Rule, ...] = (misplaced, jumps, estimated, off_graph, not_stopped, not_active, still_driving)
"""Of a robot that moves, too."""

FOLLOWING: tuple[Rule, ...] = (none_current, no_orders)
"""Of another certain reason, they are only the consequence."""

RULES: tuple[Rule, ...] = (
    misplaced,
    off_graph,
    estimated,
    not_stopped,
    still_driving,
    paused,
    *VEHICLE_REASONS,
    obstacle,
    *MEMBER_REASONS,
    *NAVIGATION_REASONS,
    own_late_pause,
    unread,
    stale_pose,
    stale_queue,
    jumps,
    unreachable,
    command,
    failed_order,
    cargo,
    at_stop,
    waits_mutually,
    waits_behind,
    charges,
    battery,
)


def _held(rules: tuple[Rule, ...], state: FleetState, robot: Robot) -> list[Reason]:
    return [reason for rule in rules if (reason := rule(state, robot)) is not None]


def _has_certain(found: list[Reason]) -> bool:
    return any(reason.strength is Strength.CERTAIN for reason in found)


def _has_alarm(state: FleetState, robot: Robot) -> bool:
    """Tell whether an alarm says what is wrong. A low battery is none: without an order it is not why a robot
    stands."""
    alarms = (one for one in state.alarms if one.holds and one.condition.source == robot.name)
    urgent = (one.condition for one in alarms if one.condition.priority is not Priority.LOW)
    return any(one.kind != "battery" for one in urgent)


def _is_told(robot: Robot, complaint: Complaint, found: list[Reason]) -> bool:
    """Tell whether a complaint is the cause in another reason."""
    told = (one.text for one in robot.logged if any(one.text in reason.name for reason in found))
    return any(complaint.text.endswith(text) for text in told)


def _unfit(state: FleetState, robot: Robot, match: "Match | None") -> list[Reason]:
    """Return the reason of a scan that does not fit the map: only while a scan is watched."""
    if match is None or not match.is_poor:
        return []
    _, keys = to_place(state, robot)
    remedy = Message("Set its pose, then search there for the best fit of its scan")
    if "pause" in keys:
        remedy = Message("Pause it and set its pose, then search there for the best fit of its scan")
    return [Reason(UNLOCALISED.word, match.text, keys=keys, remedy=remedy)]


def _of_deaf(deaf: list[Reason], load: Reason | None, others: list[Reason]) -> list[Reason]:
    """Return the reasons of a robot that is not heard: all but the link's are earlier reports."""
    told = [load] if load is not None else []
    return [deaf[0], *told, *deaf[1:], *(replace(one, strength=Strength.POSSIBLE) for one in others)]


def reasons(
    state: FleetState,
    robot: Robot,
    match: "Match | None" = None,
    complaints: Sequence[Complaint] = (),
    load: Reason | None = None,
) -> list[Reason]:
    """Return the reasons for standing still, the likeliest first: at least one. A moving robot has only the
    reason that it moves. `match`: that of its watched scan with the map, None without one. `complaints`: the
    robot's own, of which warnings count only without a certain reason; `load`: what its late bridge
    carries."""
    deaf, others = _held(DEAF, state, robot), _held(RULES, state, robot)
    if deaf:
        return _of_deaf(sorted(deaf, key=attrgetter("strength")), load, others)
    moving, unfit = moves(state, robot), _unfit(state, robot, match)
    if moving is not None and not (unfit or _held(ASTRAY, state, robot)):
        return [moving]
    others = unfit + others
    # A robot that charges needs no order.
    is_explained = _has_certain(others) or charges(state, robot) is not None
    following = [] if is_explained else _held(FOLLOWING, state, robot)
    others += following
    complaints = [one for one in complaints if not _is_told(robot, one, others)]
    if _has_certain(others):
        others += [one.reason for one in complaints if one.is_error]
    else:
        others = [one.reason for one in complaints] + others
    if all(reason.strength >= Strength.POSSIBLE for reason in others):
        others = _held((unexplained,), state, robot) + others
    if not _has_alarm(state, robot):
        following = []
    return sorted(others, key=lambda reason: (reason in following, reason.strength))
