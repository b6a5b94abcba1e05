"""Poses at which no robot can be."""

import math

import pytest
from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.events import PausedReported
from fleet_tui.model.fleet import MANY, FleetState
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.situation.alarms.trouble import next_in_trouble, to_look_at
from fleet_tui.situation.pose_checks.misplaced import HELD, misplaced_text
from fleet_tui.situation.why.reason import Strength
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import F0, R0, T0, fleet, link_up, pose, queue, reduced, tick

FRAME = MapFrame(0.05, 100, 100)
OFF, WALL = "off the map", "inside a wall"
DOUBT = "pose doubtful"
"""In the row, whatever it is that shows it: a word that does not change from second to second."""


def at(x: float, y: float, *more: events.Event) -> FleetState:
    """A room of 2 x 2 m in the corner of a map of 5 x 5 m: its right wall is 0.5 m thick, beyond is unknown
    ground."""
    above, below = bytes([255] * 100) * 60, bytes([0] * 40 + [100] * 10 + [255] * 50) * 40
    loaded = events.FloorMapLoaded(F0, grid_from_ros(FRAME, below + above))
    places = pose(T0, x, y), pose(T0, 1.0, 1.0, robot="robot_1")
    return reduced(fleet(2), link_up(T0 - 9), loaded, *places, *(more or [tick(T0)]))


@pytest.mark.parametrize(
    ("x", "y", "text"),
    [
        (1.0, 1.0, ""),
        (2.03, 1.0, ""),  # beside the wall by a cell
        (2.25, 1.0, WALL),
        (1.0, 2.9, ""),  # unknown ground, but near
        (1.0, 3.5, OFF),
        (4.0, 1.0, OFF),
        (-0.9, 1.0, ""),
        (-1.5, 1.0, OFF),
        (math.nan, 1.0, ""),
    ],
)
def test_a_pose_in_a_wall_or_away_from_known_ground_is_none(x: float, y: float, text: str) -> None:
    state = at(x, y)
    assert misplaced_text(state, state.robots[R0]) == text
    assert to_look_at(state) == ((R0,) if text else ())


def test_who_is_off_the_map_is_in_its_row_found_and_explained_first() -> None:
    state = at(-3.0, 1.0, PausedReported(R0, T0, True), tick(T0))
    robot = state.robots[R0]
    assert DOUBT in [text for text, _ in news(state, robot)]
    assert next_in_trouble(state, "") == R0
    first = reasons(state, robot)[0]
    assert (first.name, first.strength) == (f"{DOUBT}: {OFF}", Strength.CERTAIN)
    assert first.remedy.startswith("Set its pose") and first.keys[0] == "pose"


def test_who_drives_is_paused_before_its_pose_is_set() -> None:
    driving = queue(T0, (4, 1, 2, "W"), current=4)
    state = at(-3.0, 1.0, driving, tick(T0))
    first = reasons(state, state.robots[R0])[0]
    assert first.remedy.startswith("Pause it and set its pose") and first.keys[0] == "pause"
    state = at(-3.0, 1.0, driving, PausedReported(R0, T0, True), tick(T0))
    assert reasons(state, state.robots[R0])[0].keys[0] == "pose"


def test_every_robot_of_a_crowd_is_looked_at_within_half_a_second() -> None:
    state = reduced(at(1.0, 1.0), tick(T0))
    everyone = {f"r{n}": replace(state.robots[R0], name=f"r{n}") for n in range(MANY)}
    off = [pose(T0 + 0.05, -3.0, 1.0, robot=name) for name in everyone]
    found, last = [], reduced(replace(state, robots=everyone), *off)
    for n in range(1, 6):
        last = reduced(last, tick(T0 + n / 10))
        found.append(sum(misplaced_text(last, robot) == OFF for robot in last.robots.values()))
    assert found[0] <= MANY / 4 and found[-1] == MANY


def test_an_old_pose_off_the_map_is_no_news_of_today() -> None:
    state = at(-3.0, 1.0, tick(T0), tick(T0 + 60))
    assert DOUBT not in [text for text, _ in news(state, state.robots[R0])]


def test_without_a_map_no_pose_is_wrong() -> None:
    state = reduced(fleet(), link_up(T0 - 9), pose(T0, -300.0, 1.0), tick(T0))
    assert misplaced_text(state, state.robots[R0]) == "" and not to_look_at(state)


def test_it_is_told_also_of_a_robot_that_moves() -> None:
    state = at(-3.0, 1.0, pose(T0 + 0.5, -3.2, 1.0), tick(T0 + 0.5))
    assert reasons(state, state.robots[R0])[0].name == f"{DOUBT}: {OFF}"


def left(seconds: float) -> FleetState:
    """A robot that drove out of the wall, some seconds ago."""
    drives: list[events.Event] = [pose(T0 + 0.5, 1.8, 1.0), tick(T0 + 0.5), pose(T0 + seconds, 1.7, 1.0)]
    return at(2.25, 1.0, tick(T0), *drives, tick(T0 + seconds))


def test_a_pose_that_crosses_walls_stays_worth_a_look_with_its_age() -> None:
    state = left(12.0)
    robot = state.robots[R0]
    assert DOUBT in [text for text, _ in news(state, robot)]
    assert to_look_at(state) == (R0,)
    between = left(0.6).robots[R0]  # poses come between ticks
    assert misplaced_text(left(0.6), between) == WALL
    first = reasons(state, robot)[0]
    assert (first.name, first.strength) == (f"{DOUBT}: in a wall 12 s ago", Strength.LIKELY)
    assert first.seen == T0
    assert "was just at an impossible place" in first.evidence and first.remedy.startswith("Set its pose")
    over = left(HELD + 1.0)
    assert misplaced_text(over, over.robots[R0]) == "" and not to_look_at(over)


def test_a_pose_put_right_is_right_at_once() -> None:
    state = at(2.25, 1.0, tick(T0), pose(T0 + 0.1, 0.2, 1.0), tick(T0 + 0.1))
    assert state.robots[R0].relocated is not None
    assert misplaced_text(state, state.robots[R0]) == ""


def test_a_map_that_changes_under_a_standing_robot_ends_it() -> None:
    free = grid_from_ros(FRAME, bytes(100 * 100))
    state = at(2.25, 1.0, tick(T0), events.FloorMapLoaded(F0, free), tick(T0 + 0.1))
    assert misplaced_text(state, state.robots[R0]) == ""


def crossing(*seconds: float, until: float) -> FleetState:
    """A robot whose pose is in the wall at T0 and at each of these seconds, and free at the last one."""
    path: list[events.Event] = [
        one
        for after in seconds
        for one in (pose(T0 + after - 0.2, 2.22 + after / 1000, 1.0), tick(T0 + after - 0.2))
    ]
    return at(2.25, 1.0, tick(T0), *path, pose(T0 + until, 2.0, 1.0), tick(T0 + until))


def alarms_of(state: FleetState) -> list[str]:
    return [one.condition.text for one in state.alarms if one.condition.kind == "localisation"]


def test_poses_that_are_none_for_twenty_seconds_are_an_alarm_until_they_have_ceased() -> None:
    assert not alarms_of(crossing(until=12.0)) and not alarms_of(crossing(10.0, until=25.0))
    assert not alarms_of(crossing(45.0, until=46.0)), "two spells, each of a moment"
    lasting = crossing(10.0, 21.0, until=22.0)
    assert alarms_of(lasting) == ["pose doubtful for 22 s: inside a wall"]
    over = reduced(lasting, pose(T0 + 60, 1.9, 1.0), tick(T0 + 60))
    assert not any(one.holds for one in over.alarms if one.condition.kind == "localisation")
