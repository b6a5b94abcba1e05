"""Poses at which a robot cannot be: inside a wall, away from all known ground, or off its routes."""

import math
from collections.abc import Iterable, Mapping

from msgspec.structs import replace

from fleet_tui.model.fleet import MANY, FleetState
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.grid import FREE, OCCUPIED, OccupancyGrid
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.orders.mode import mapping_text
from fleet_tui.situation.pose_checks.off_route import is_off_route
from fleet_tui.text.language import EMPTY, N_, Message
from fleet_tui.text.units import age

SIZE = 1.0, 1.0
"""Length and width in metres of a robot that tells none."""
BESIDE = 0.1
"""Metres from free ground at which a pose in a wall may be one beside it."""

LiveMaps = Mapping[str, OccupancyGrid]
"""By floors."""
WALL = N_("inside a wall")
OFF_ROUTE = N_("off the route graph")
TURNS = 5
"""Parts of many robots that are looked at one after the other."""
NOW = 1.0
"""Seconds to the newest pose within which such a pose is one of this moment."""
HELD = 30.0
"""Seconds for which such a pose counts after the robot has left it: a wrong one crosses shelf after shelf."""
LASTS = 20.0
"""Seconds over which such poses must go on, now and then, to be an alarm."""


def with_misplaced(state: FleetState, before: float) -> FleetState:
    """Return the state with the newest misplaced pose of each robot. Called once a tick; `before` is the time
    of the last one."""
    live = _live(state)
    changed = {
        robot.name: replace(robot, misplaced=seen, misplaced_since=_since(robot, seen))
        for robot in _due(state, before)
        if (seen := _newest(state, robot, live, before)) is not robot.misplaced
    }
    return replace(state, robots={**state.robots, **changed}) if changed else state


def _due(state: FleetState, before: float) -> Iterable[Robot]:
    """Return the robots to look at in this tick: all, of many each twice a second, in turn."""
    robots = state.robots.values()
    if len(robots) < MANY:
        return robots
    due = [_half(turn, state.now) != _half(turn, before) for turn in range(TURNS)]
    return [robot for robot in robots if due[robot.number % TURNS]]


def _half(turn: int, at: float) -> int:
    """Return the half second that lasts then for the robots of a turn."""
    return math.floor(2 * at + turn / TURNS)


def _newest(state: FleetState, robot: Robot, live: LiveMaps, before: float) -> Reading[str] | None:
    if robot.is_estimated:
        return None
    text, seen = _text(state, robot, live), robot.misplaced
    if not text and _is_turn(robot, before, state.now) and is_off_route(robot):
        text = OFF_ROUTE
    if robot.pose is None:
        return None
    if not text and seen is not None and seen.at == robot.pose.at and seen.value != OFF_ROUTE:
        return None  # the map has changed
    found = Reading(text, robot.pose.at)
    return found if text and seen != found else seen


def _is_turn(robot: Robot, before: float, now: float) -> bool:
    """Tell whether a robot's second ends in this tick: its whole graph is looked at only then, and those of
    the others in other ticks."""
    turn = robot.number % TURNS
    return _half(turn, now) // 2 != _half(turn, before) // 2


def _since(robot: Robot, seen: Reading[str] | None) -> float | None:
    """Return when misplaced poses began, `seen` the newest: shorter gaps than HELD end nothing."""
    last = robot.misplaced
    if seen is None or last is None or seen.at - last.at >= HELD or _is_found(robot, last):
        return seen.at if seen is not None else None
    return robot.misplaced_since


def _is_found(robot: Robot, seen: Reading[str]) -> bool:
    """Tell whether its localisation has found a robot elsewhere since a misplaced pose."""
    return robot.relocated is not None and robot.relocated.at > seen.at


def misplaced_for_long(state: FleetState, robot: Robot) -> float | None:
    """Return since when poses of a robot are no places, None if not for so long that it is surely lost."""
    seen, since = robot.misplaced, robot.misplaced_since
    if seen is None or since is None or seen.at - since < LASTS or not misplaced_text(state, robot):
        return None
    return since


def is_misplaced(robot: Robot) -> bool:
    """Tell whether the last pose of a robot is no place on its floor; poses are looked at once a tick."""
    seen, pose = robot.misplaced, robot.pose
    return seen is not None and pose is not None and pose.at - seen.at < NOW


def misplaced_text(state: FleetState, robot: Robot) -> Message:
    """Return why the last pose of a robot is no place on its floor, or one a short while ago was none; empty
    otherwise, and once its localisation has found it elsewhere."""
    seen = robot.misplaced
    if seen is None or _is_found(robot, seen):
        return EMPTY
    if is_misplaced(robot):
        return Message(seen.value)
    if state.now - seen.at >= HELD:
        return EMPTY
    if seen.value == OFF_ROUTE:
        return Message("off the route graph {age} ago", age=age(state.now - seen.at))
    return (
        Message("in a wall {age} ago", age=age(state.now - seen.at))
        if seen.value == WALL
        else Message("off map {age} ago", age=age(state.now - seen.at))
    )


def _text(state: FleetState, robot: Robot, live: LiveMaps) -> str:
    """Return why the last pose of a robot is no place, empty if it may be one, or no map is known. Whoever
    makes a map is beyond it."""
    ground = _ground(state, robot, live) if robot.pose is not None else None
    if robot.pose is None or ground is None:
        return EMPTY
    (grid, frame), pose = ground, robot.pose.value
    column, row = frame.to_pixel(pose.x, pose.y)
    if not (abs(column) < 1e9 and abs(row) < 1e9):
        return EMPTY  # no number at all: told as bad data
    here = FREE
    is_on = 0.0 <= column < frame.width and 0.0 <= row < frame.height
    if is_on:
        here = int(grid.levels[0][int(row), int(column)])
        if here == FREE:  # nearly always: this is asked of every robot in every tick
            return EMPTY
    if here == OCCUPIED:
        return EMPTY if _is_free(grid, frame, column, row, BESIDE) else WALL
    reach = max(robot.size or SIZE)
    away = max(-column, column - frame.width, -row, row - frame.height) * frame.resolution
    is_off = away > reach or not _is_free(grid, frame, column, row, reach)
    return Message("off the map") if is_off and not mapping_text(robot) else ""


def _is_free(grid: OccupancyGrid, frame: MapFrame, column: float, row: float, reach: float) -> bool:
    """Tell whether there is free ground so many metres around a pixel."""
    across, left, top = round(reach / frame.resolution), int(column), int(row)
    rows, columns = (slice(max(at - across, 0), max(at + across + 1, 0)) for at in (top, left))
    return bool((grid.levels[0][rows, columns] == FREE).any())


def _ground(state: FleetState, robot: Robot, others: LiveMaps) -> tuple[OccupancyGrid, MapFrame] | None:
    """Return the map of a robot's floor, and where the robot has it: as the picture shows it, the file first,
    then a live map, its own or that of `others`."""
    floor = state.floors.get(robot.floor or "")
    if floor is None:
        return None
    own = robot.maps.get(floor.name)
    if floor.grid is not None:
        frame = floor.grid.frame if floor.tied else own.frame if own is not None else None
        size = floor.grid.frame.width, floor.grid.frame.height
        return (floor.grid, frame) if frame is not None and (frame.width, frame.height) == size else None
    live = (own.grid if own is not None else None) or floor.live or others.get(floor.name)
    if live is None or (own is not None and own.frame not in (None, live.frame)):
        return None
    return live, live.frame


def _live(state: FleetState) -> LiveMaps:
    """Return a live map of each floor of which a robot has one, where floors have no file."""
    if all(floor.grid is not None for floor in state.floors.values()):
        return {}
    maps = ((name, one.grid) for robot in state.robots.values() for name, one in robot.maps.items())
    return {name: grid for name, grid in maps if grid is not None}
