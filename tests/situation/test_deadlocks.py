"""Two robots that wait for each other, from their poses, their graph and their orders."""

import pytest

from fleet_tui.cli.status.report import attention
from fleet_tui.model.events import Event, ObstacleReported, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.activity import activities
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.lines.why import why_lines
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.tables.doing import state_texts
from tests.support.fleets import F0, R0, T0, pose, queue, reduced, tick
from tests.support.kinds import KEYS
from tests.support.situations import face_to_face as simulated
from tests.support.street import fleet_with

R1 = "robot_1"
WORD = "waits for robot_1, which waits for it"
At = tuple[float, float]


def seconds_of(
    state: FleetState, seconds: int, here: At, there: At, stops: tuple[int, int], *others: Event
) -> FleetState:
    """Let both robots report for so long where they stand, and their orders to one vertex each."""
    for _ in range(seconds):
        at = state.now + 1.0
        reports = (
            pose(at, *here),
            pose(at, *there, robot=R1),
            queue(at, (1, stops[0], stops[0], "W"), current=1),
            queue(at, (1, stops[1], stops[1], "W"), current=1, robot=R1),
        )
        state = reduced(state, *reports, *others, tick(at))
    return state


def face_to_face(seconds: int = 40, *others: Event) -> FleetState:
    """robot_0 wants to go from 2 to 5, robot_1 from 3 to 1: both over the edge 2 - 3."""
    return seconds_of(fleet_with(), seconds, (10.0, 0.0), (18.0, 0.0), (5, 1), *others)


def alarms(state: FleetState) -> list[str]:
    return [f"{one.condition.source}: {one.text}" for one in state.alarms if one.holds]


def test_it_is_the_one_cause_of_standing_however_long() -> None:
    state = face_to_face(100)
    assert len(alarms(state)) == 2 and all("which waits for it" in text for text in alarms(state))
    assert not [one.name for one in reasons(state, state.robots[R0]) if "behind" in one.name]


def test_row_alarm_reason_and_map_agree_on_two_robots_that_wait_for_each_other() -> None:
    state = face_to_face()
    assert alarms(state) == [f"{R0}: {WORD}", f"{R1}: waits for robot_0, which waits for it"]
    first = reasons(state, state.robots[R0])[0]
    assert first.name == WORD and first.remedy == state.alarms[0].condition.remedy
    assert first.remedy.startswith("Send one of them away")
    robot = state.robots[R0]
    does = activities(state, [robot])[R0]
    assert [text for text, _ in state_texts(state, robot, does, 80)] == [WORD]
    scene = floor_scene(state, Selection(R0, F0))
    assert set(scene.deadlocked) == {
        (10.0, 0.0, 20.0, 0.0),
        (20.0, 0.0, 30.0, 0.0),
        (18.0, 0.0, 10.0, 0.0),
        (10.0, 0.0, 0.0, 0.0),
    }


def test_the_simulators_robots_show_it_on_every_page() -> None:
    """What a console hears, and what it then says: row, alarms, `w` and `fleet-tui status`."""
    planted = simulated().run(45)
    state, robot = planted.state, planted.robot
    row = [text for text, _ in state_texts(state, robot, activities(state, [robot])[R0], 80)]
    why = why_lines(state, robot, KEYS)
    assert row == [WORD] and f"{R0}: {WORD}" in alarms(state)
    assert f"1. {WORD}" in why[2], why
    assert any(f"{R0}: {WORD}" in line for line in attention(state))
    planted.world.robots[R1].orders.clear()
    assert not any(WORD in text for text in alarms(planted.run(10).state))


def test_it_is_a_word_at_once_and_an_alarm_after_half_a_minute() -> None:
    state = face_to_face(12)
    assert reasons(state, state.robots[R0])[0].name == WORD and alarms(state) == []
    assert floor_scene(state, Selection(R0, F0)).deadlocked == ()


def test_it_is_over_once_one_of_them_has_left() -> None:
    state = seconds_of(face_to_face(), 10, (10.0, 0.0), (10.0, 5.0), (5, 4))
    assert state.deadlocks == {} and not any(WORD in text for text in alarms(state))


@pytest.mark.parametrize("other", [ObstacleReported(R1, T0 + 80, 60.0), PausedReported(R1, T0 + 80, True)])
def test_a_robot_that_a_pause_or_an_obstacle_holds_waits_for_nobody(other: Event) -> None:
    assert face_to_face(12, other).deadlocks == {}


@pytest.mark.parametrize(
    ("here", "there", "stops", "wait"),
    [
        pytest.param((8.0, 0.0), (10.0, 2.5), (5, 1), True, id="before the same crossing"),
        pytest.param((9.8, 0.0), (18.0, 0.0), (5, 1), True, id="one a little before its vertex"),
        pytest.param((16.0, 0.0), (18.0, 0.0), (5, 5), False, id="one behind the other"),
        pytest.param((16.0, 0.0), (15.0, 2.5), (1, 3), False, id="on two lanes"),
        pytest.param((12.0, 0.0), (28.0, 0.0), (5, 1), False, id="both far from their crossing"),
        pytest.param((10.0, 0.0), (20.0, 0.0), (5, 5), False, id="bound for one place"),
        pytest.param((5.0, 0.0), (25.0, 0.0), (5, 1), False, id="an edge apart"),
        pytest.param((5.0, 0.0), (9.0, 0.0), (2, 2), False, id="behind one that is nearly there"),
        pytest.param((0.0, 0.0), (10.0, 0.0), (5, 2), False, id="one at its stop"),
    ],
)
def test_only_robots_on_each_others_next_edge_wait_for_each_other(
    here: At, there: At, stops: tuple[int, int], wait: bool
) -> None:
    state = seconds_of(fleet_with(), 12, here, there, stops)
    assert set(state.deadlocks) == ({R0, R1} if wait else set())


def test_robots_that_drive_or_have_no_order_wait_for_nobody() -> None:
    state = fleet_with()
    for second in range(12):
        at = T0 + 1 + second
        state = reduced(
            state,
            pose(at, 8.0 + 0.2 * second, 0.0),
            pose(at, 18.0, 0.0, robot=R1),
            queue(at, (1, 5, 5, "W"), current=1),
            queue(at, (1, 1, 1, "W"), current=1, robot=R1),
            tick(at),
        )
    assert state.deadlocks == {}
    idle = face_to_face(12, queue(T0, robot=R1))
    assert idle.deadlocks == {}
