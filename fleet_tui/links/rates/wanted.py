"""Intervals that each robot's messages should have, by attention."""

from collections.abc import Collection, Iterable, Mapping

from fleet_tui.model.attention import Attention, Intervals, Rates
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.trouble import by_urgency

FULL = Intervals()
STEPS = 200, 500
"""Milliseconds between poses, besides none and the longest: few steps, so that a zoom changes little."""
USUAL = 100
"""Milliseconds between poses at the usual full rate."""
SPEED = 1.5
"""Metres a second of a robot that drives fast."""
MOST_SHOWN = 1000
"""Poses a second of all robots in view: nobody follows more than a hundred of them with their eyes."""
MOST_ALARMED = 20
"""Robots with an alarm that have the full rate, the most urgent ones: in a flood nobody looks at all."""


def is_large(state: FleetState, rates: Rates) -> bool:
    """Tell whether a fleet is too large for the full rate of all its robots."""
    return len(state.robots) > rates.full_up_to


def watched_robots(state: FleetState, attention: Attention) -> list[str]:
    """Return the robots that always have the full rate, the most urgent first: the selected one, those with a
    command under way, and the most urgent ones with an alarm. An order that waits here is about none yet."""
    under_way = (one for one in state.commands if not (one.is_decided or one.stage is Stage.WAITING))
    commanded = [one.command.robot for one in under_way]
    alarmed = by_urgency(state)[:MOST_ALARMED]
    return list(dict.fromkeys([attention.robot, *reversed(commanded), *alarmed]))


def shown_interval(cell: float, longest: int) -> int:
    """Return the milliseconds between poses within which a robot moves less than a cell of so many metres on
    the map; 0 if only the full rate is enough."""
    visible = round(cell / SPEED * 1000)
    return max((step for step in (0, *STEPS, longest) if step <= min(visible, longest)), default=0)


def crowd_interval(robots: int, longest: int) -> int:
    """Return the milliseconds between poses at which so many robots in view send few enough."""
    least = robots / MOST_SHOWN * 1000
    return next((step for step in (0, *STEPS) if max(step, USUAL) >= least and step <= longest), longest)


def is_in_view(robot: Robot, attention: Attention) -> bool:
    """Tell whether the map shows a robot."""
    view, pose = attention.view, robot.pose
    if view is None or pose is None or robot.floor != attention.floor:
        return False
    return view.shows(pose.value.x, pose.value.y)


def intervals(
    state: FleetState, robots: Iterable[str], attention: Attention, rates: Rates
) -> Mapping[str, Intervals]:
    """Return the intervals that the messages of these robots should have, the most watched first: without an
    operator, as in a recording or for metrics, everything counts."""
    if not is_large(state, rates) or not attention.robot:
        return dict.fromkeys(robots, FULL)
    watched, shown = {name: n for n, name in enumerate(watched_robots(state, attention))}, rates.pose_ms
    if attention.view is not None:
        seen = sum(is_in_view(robot, attention) for robot in state.robots.values())
        by_zoom = shown_interval(attention.view.cell, rates.pose_ms)
        shown = max(by_zoom, crowd_interval(seen, rates.pose_ms))
    ordered = sorted(robots, key=lambda name: watched.get(name, len(watched)))
    return {name: _intervals(state.robots[name], watched, attention, shown, rates) for name in ordered}


def _intervals(
    robot: Robot, watched: Collection[str], attention: Attention, shown: int, rates: Rates
) -> Intervals:
    if robot.name in watched:
        return FULL
    if is_in_view(robot, attention):
        return Intervals(shown, rates.status_ms)
    return Intervals(rates.pose_ms, rates.status_ms, unseen=1)


def by_attention(state: FleetState, attention: Attention) -> Mapping[str, int]:
    """Return the place of each robot in the order of attention: the watched ones, those of the shown floor,
    the others."""
    watched = {name: place for place, name in enumerate(watched_robots(state, attention))}
    last = len(watched)
    return {
        name: watched.get(name, last + (attention.floor not in _floors(robot)))
        for name, robot in state.robots.items()
    }


def _floors(robot: Robot) -> Collection[str]:
    """Return the floor of a robot, or while it is unknown all that it may be on."""
    return (robot.floor,) if robot.floor is not None else robot.maps
