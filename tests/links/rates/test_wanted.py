"""What is looked at comes often, everything else seldom, and a small fleet as ever."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.links.rates.wanted import (
    FULL,
    MOST_ALARMED,
    MOST_SHOWN,
    SPEED,
    USUAL,
    by_attention,
    crowd_interval,
    intervals,
    shown_interval,
)
from fleet_tui.model.attention import Attention, Intervals, Rates, SeenArea
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.desk.events import AlarmShelved
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import (
    F0,
    R0,
    T0,
    battery,
    commanded,
    fleet,
    link_up,
    place_order,
    pose,
    reduced,
    tick,
)

RATES = Rates(full_up_to=3)
SELDOM = Intervals(RATES.pose_ms, RATES.status_ms, unseen=1)
F1 = F0.replace("0", "1")
WHOLE = SeenArea(-100.0, -100.0, 100.0, 100.0, 0.4)


def placed(*facts: Event, robots: int = 6) -> FleetState:
    """Robots, the even ones on the first floor, each ten metres further on."""
    poses = [pose(T0, x=10.0 * n, robot=f"robot_{n}", frame=F1 if n % 2 else F0) for n in range(robots)]
    return reduced(fleet(robots, 2), link_up(T0), *poses, *facts, tick(T0))


def rates(state: FleetState, attention: Attention, limits: Rates = RATES) -> dict[str, Intervals]:
    return dict(intervals(state, state.robots, attention, limits))


def test_the_selected_robot_comes_fully_those_in_view_as_the_zoom_shows_and_the_others_seldom() -> None:
    found = rates(placed(), Attention(R0, F0, WHOLE))
    assert found[R0] == FULL
    assert found["robot_2"] == found["robot_4"] == Intervals(200, RATES.status_ms)
    assert found["robot_1"] == found["robot_3"] == found["robot_5"] == SELDOM


def test_who_is_out_of_view_comes_seldom() -> None:
    found = rates(placed(), Attention(R0, F0, WHOLE._replace(right=25.0)))
    assert (found["robot_2"].pose, found["robot_4"]) == (200, SELDOM)
    assert rates(placed(), Attention(R0, F0))["robot_2"] == SELDOM  # without a map


def test_a_small_fleet_has_its_full_rate() -> None:
    assert set(rates(placed(robots=3), Attention(R0)).values()) == {FULL}
    assert set(rates(placed(robots=4), Attention(R0)).values()) == {FULL, SELDOM}


def test_without_an_operator_everything_counts() -> None:
    assert set(rates(placed(), Attention()).values()) == {FULL}, "as for a recording, or metrics"


def test_a_command_under_way_makes_its_robot_come_fully() -> None:
    given_one = commanded(1, PauseRobot("robot_5"), Stage.SENT)
    state = placed(*given_one)
    assert rates(state, Attention(R0, F0))["robot_5"] == FULL
    ended = placed(*commanded(1, PauseRobot("robot_5"), Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED))
    assert rates(ended, Attention(R0, F0))["robot_5"] == SELDOM


def test_an_order_that_waits_here_is_about_no_robot_yet() -> None:
    waits = commanded(1, place_order("robot_5", 1, 2), Stage.WAITING)
    assert rates(placed(*waits), Attention(R0, F0))["robot_5"] == SELDOM


def test_the_selected_robot_is_the_first_of_those_whose_rate_changes() -> None:
    many = [one for n in (1, 2, 3, 4) for one in commanded(n, PauseRobot(f"robot_{n}"), Stage.SENT)]
    assert next(iter(rates(placed(*many), Attention("robot_5", F0)))) == "robot_5"


def test_in_a_crowd_that_comes_seldom_who_is_in_view_is_still_seen() -> None:
    found = rates(placed(), Attention(R0, F0, WHOLE._replace(cell=9.0)))
    assert found["robot_2"] == SELDOM._replace(unseen=0) and found["robot_1"] == SELDOM


def test_a_robot_with_an_alarm_comes_fully_until_that_is_shelved() -> None:
    state = placed(battery(T0, 5.0, "robot_3"))
    assert rates(state, Attention(R0, F0))["robot_3"] == FULL
    shelved = reduced(state, AlarmShelved("robot_3", "battery", T0 + 60))
    assert rates(shelved, Attention(R0, F0))["robot_3"] == SELDOM


def test_of_a_flood_only_the_most_urgent_ones_come_fully() -> None:
    low = [battery(T0, 15.0, f"robot_{n}") for n in range(40)]
    state = placed(*low, battery(T0, 3.0, "robot_39"), robots=40)
    found = rates(state, Attention("robot_38", F0))
    assert list(found.values()).count(FULL) == MOST_ALARMED + 1
    assert found["robot_38"] == found["robot_39"] == FULL


@given(st.floats(0.001, 100.0), st.integers(1, 60_000))
def test_between_two_poses_a_robot_stays_in_its_cell(cell: float, longest: int) -> None:
    found = shown_interval(cell, longest)
    assert found <= longest and found / 1000 * SPEED <= cell + 0.001


@pytest.mark.parametrize("cell, ms", [(0.05, 0), (0.3, 200), (0.75, 500), (1.5, 1000), (9.0, 1000)])
def test_the_closer_the_view_the_more_often(cell: float, ms: int) -> None:
    assert shown_interval(cell, 1000) == ms


def test_topics_are_subscribed_for_the_watched_robots_first_then_for_the_shown_floor() -> None:
    state = placed(*commanded(1, PauseRobot("robot_3"), Stage.SENT))
    places = by_attention(state, Attention("robot_5", F0))
    assert sorted(places, key=lambda name: places[name]) == [
        *("robot_5", "robot_3"),
        *("robot_0", "robot_2", "robot_4"),
        "robot_1",
    ]


def test_while_its_floor_is_unknown_a_robot_may_be_on_any() -> None:
    state = fleet(2, 2)
    robot = replace(state.robots["robot_1"], floor=F1)
    places = by_attention(replace(state, robots={**state.robots, "robot_1": robot}), Attention("", "floor_0"))
    assert places["robot_0"] < places["robot_1"]


@given(st.integers(0, 1000), st.integers(1000, 60_000))
def test_a_crowd_in_view_sends_no_more_than_the_eye_can_follow(robots: int, longest: int) -> None:
    assert robots * 1000 / max(crowd_interval(robots, longest), USUAL) <= MOST_SHOWN
    assert crowd_interval(robots, longest) <= longest


def test_the_more_robots_in_view_the_less_often() -> None:
    assert [crowd_interval(robots, 1000) for robots in (10, 100, 150, 300, 900)] == [0, 0, 200, 500, 1000]
