"""The robots in trouble: marked and listed first, and named where their floor is not shown."""

from collections.abc import Iterable

from fleet_tui.model.alarm import Alarm, AlarmStage
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState, is_missing
from fleet_tui.model.order import natural
from fleet_tui.model.robot import Robot
from fleet_tui.rules.commands.newest import own_pause
from fleet_tui.rules.localisation.jumps import is_jumping

LONG_STILL = 30.0
"""Seconds of standing with an order that are worth a look: longer than loading takes."""


def waits(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot has stood with an order for so long, by poses that still hold."""
    stands = robot.still_for >= LONG_STILL and robot.orders.current is not None
    return stands and state.is_fresh(robot, "pose")


def may_need_person(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot waits with an order, is in a mode, such as MANUAL, in which it takes none, or has
    a pose that jumps."""
    by_hand = robot.vehicle is not None and not robot.vehicle.value.takes_orders
    by_hand = by_hand and state.is_fresh(robot, "vehicle")
    jumps = state.is_fresh(robot, "pose") and is_jumping(robot, state.now)
    return waits(state, robot) or by_hand or jumps


def in_trouble(state: FleetState) -> frozenset[str]:
    """Return the names of the robots with an alarm that is neither over nor shelved. Its off-delay keeps
    their rows where they are."""
    over = (AlarmStage.SHELVED, AlarmStage.RETURNED)
    return _robots(state, (one for one in state.alarms if one.stage not in over))


def shelved(state: FleetState) -> frozenset[str]:
    """Return the names of the robots whose trouble goes on while its alarm is shelved."""
    return _robots(state, (one for one in state.alarms if one.stage is AlarmStage.SHELVED and one.holds))


def acknowledged(state: FleetState) -> frozenset[str]:
    """Return the names of the robots with alarms that all are acknowledged, those of their links included."""
    return _concerned(state, AlarmStage.ACKNOWLEDGED) - _concerned(state, AlarmStage.UNACKNOWLEDGED)


def _concerned(state: FleetState, stage: AlarmStage) -> frozenset[str]:
    alarms = [one for one in state.alarms if one.stage is stage]
    links = {one.condition.source for one in alarms} & state.links.keys()
    if not links:  # asked several times a tick
        return _robots(state, alarms)
    return _robots(state, alarms) | {robot.name for robot in state.robots.values() if robot.link in links}


def _robots(state: FleetState, alarms: Iterable[Alarm]) -> frozenset[str]:
    named = {name for one in alarms for name in _whose(one)}
    return frozenset(named & state.robots.keys())


def urgency(alarm: Alarm) -> tuple[bool, bool, bool, int]:
    """Return the sort key of an alarm. Equal ones stay in the order in which they were raised. Alarms that
    are over are below all that hold, whatever their priority."""
    is_over = alarm.stage is AlarmStage.RETURNED
    is_shelved, priority = alarm.stage is AlarmStage.SHELVED, alarm.condition.priority.value
    return is_shelved, is_over, not alarm.needs_acknowledgement, priority


def by_urgency(state: FleetState) -> list[str]:
    """Return the robots in trouble in the order of the alarms pane."""
    alarms, troubled = sorted(state.alarms, key=urgency), in_trouble(state)
    return list(dict.fromkeys(name for one in alarms for name in _whose(one) if name in troubled))


def next_in_trouble(state: FleetState, after: str, marked: object = None) -> str:
    """Return the robot of the marked alarm. If `after` has it, or it is no robot's, return the next one in
    the order of the alarms pane, of those that need a person while there are some; after them those without
    an alarm that may need one; then around. Empty if there is none."""
    troubled, known, silenced = by_urgency(state), acknowledged(state), shelved(state)
    odd = [
        name
        for name, robot in state.robots.items()
        if name not in troubled and (name in silenced or _is_odd(state, robot))
    ]
    of_marked = {name for one in state.alarms if one.key == marked for name in _whose(one)}
    # After one without an alarm, the marked alarm is the one that it came from.
    goes_on = after in of_marked or after in odd
    if not goes_on and (found := [name for name in troubled if name in of_marked]):
        return found[0]
    names = [*([name for name in troubled if name not in known] or troubled), *odd]
    start = names.index(after) + 1 if after in names else 0
    return names[start % len(names)] if names else ""


def _is_odd(state: FleetState, robot: Robot) -> bool:
    is_held = state.is_paused(robot) and own_pause(state, robot) is None
    is_held = is_held or state.is_obstructed(robot) or is_missing(state, robot, "pose")
    # Where its load is somebody has to see.
    has_lost = robot.orders.current is None and any(one.stage is Stage.LOST for one in robot.gone)
    return is_held or has_lost or may_need_person(state, robot)


def _whose(alarm: Alarm) -> list[str]:
    return [alarm.condition.source, *sorted(alarm.condition.parts, key=natural)]


def trouble_elsewhere(state: FleetState, floor: str) -> str:
    """Return who is in trouble on other floors than this one, empty if nobody of whom nobody knows."""
    away = [state.robots[name] for name in sorted(in_trouble(state) - acknowledged(state))]
    away = [robot for robot in away if robot.floor not in (None, floor)]
    if len(away) == 1:
        return f"! {away[0].name} on {away[0].floor}"
    return f"! {len(away)} on other floors" if away else ""
