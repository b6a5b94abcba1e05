"""The robots in trouble: marked and listed first, and named where their floor is not shown."""

from collections.abc import Iterable

from fleet_tui.model.alarm import Alarm, AlarmStage
from fleet_tui.model.fleet import FleetState, is_missing


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
    return _robots(state, alarms) | {robot.name for robot in state.robots.values() if robot.link in links}


def _robots(state: FleetState, alarms: Iterable[Alarm]) -> frozenset[str]:
    named = {name for one in alarms for name in (one.condition.source, *one.condition.parts)}
    return frozenset(named & state.robots.keys())


def urgency(alarm: Alarm) -> tuple[bool, bool, bool, int]:
    """Return the sort key of an alarm. Equal ones stay in the order in which they were raised. Alarms that
    are over are below all that hold, whatever their priority."""
    is_over = alarm.stage is AlarmStage.RETURNED
    is_shelved, priority = alarm.stage is AlarmStage.SHELVED, alarm.condition.priority.value
    return is_shelved, is_over, not alarm.needs_acknowledgement, priority


def next_in_trouble(state: FleetState, after: str) -> str:
    """Return the next robot in trouble after this one, in the order of the alarms pane and around its end; if
    none is, one whose alarm is shelved or whose pose is missing; empty without one."""
    troubled, silenced = in_trouble(state), shelved(state)
    alarms = sorted(state.alarms, key=urgency)
    names = [name for one in alarms for name in (one.condition.source, *sorted(one.condition.parts))]
    names = list(dict.fromkeys(name for name in names if name in troubled)) or [
        name for name, robot in state.robots.items() if name in silenced or is_missing(state, robot, "pose")
    ]
    start = names.index(after) + 1 if after in names else 0
    return names[start % len(names)] if names else ""


def trouble_elsewhere(state: FleetState, floor: str) -> str:
    """Return who is in trouble on other floors than this one, empty if nobody of whom nobody knows."""
    away = [state.robots[name] for name in sorted(in_trouble(state) - acknowledged(state))]
    away = [robot for robot in away if robot.floor not in (None, floor)]
    if len(away) == 1:
        return f"! {away[0].name} on {away[0].floor}"
    return f"! {len(away)} on other floors" if away else ""
