"""Which robot and floor are looked at: steps go around, the floor moves only when it should."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.ui.view.selection import Selection, first_selection
from tests.support.fleets import F0, R0, T0, battery, fleet, pose, reduced


def test_the_first_robot_of_the_config_and_its_first_floor() -> None:
    assert first_selection(fleet(3, 3)) == Selection(R0, F0)


def test_steps_go_around_the_ends() -> None:
    state, start = fleet(3, 2), Selection(R0, F0)
    assert start.step_robot(state, -1).robot == "robot_2"
    assert start.step_robot(state, 1).step_robot(state, 1).step_robot(state, 1) == start
    assert start.step_floor(state, -1).floor == "floor_1"
    assert start.step_floor(state, 1).step_floor(state, 1).floor == F0


@given(st.lists(st.tuples(st.booleans(), st.integers(-3, 3)), max_size=20))
def test_any_steps_stay_in_the_fleet_and_can_be_taken_back(steps: list[tuple[bool, int]]) -> None:
    state = fleet(3, 2)
    there = Selection(R0, F0)
    for of_robot, step in steps:
        there = there.step_robot(state, step) if of_robot else there.step_floor(state, step)
        assert there.robot in state.robots and there.floor in state.floors
    back = there
    for of_robot, step in reversed(steps):
        back = back.step_robot(state, -step) if of_robot else back.step_floor(state, -step)
    assert (back.robot, back.floor) == (R0, F0)


def test_after_the_start_the_floor_becomes_the_first_robots_once() -> None:
    state = fleet(2, 2)
    start = first_selection(state)
    assert start.settled(state, follow=False) == start
    upstairs = reduced(state, pose(T0, frame="floor_1"))
    settled = start.settled(upstairs, follow=False)
    assert settled.floor == "floor_1"
    back = reduced(upstairs, pose(T0 + 1))
    assert settled.settled(back, follow=False).floor == "floor_1"
    assert settled.settled(back, follow=True).floor == F0


def test_a_chosen_floor_stays_unless_the_map_follows() -> None:
    state = reduced(fleet(2, 2), pose(T0))
    chosen = Selection(R0, F0).step_floor(state, 1)
    assert chosen.settled(state, follow=False).floor == "floor_1"
    assert chosen.settled(state, follow=True).floor == F0


def test_another_robot_brings_the_map_to_its_floor_once() -> None:
    state = reduced(fleet(2, 2), pose(T0), pose(T0, robot="robot_1", frame="floor_1"))
    start = first_selection(state).settled(state, follow=False)
    other = start.on_robot("robot_1")
    shown = other.settled(state, follow=False)
    assert shown.floor == "floor_1"
    back = reduced(state, pose(T0 + 1, robot="robot_1"))
    assert shown.settled(back, follow=False).floor == "floor_1"
    assert shown.settled(back, follow=True).floor == F0


def test_an_unknown_floor_moves_nothing() -> None:
    state = reduced(fleet(1, 2), pose(T0, frame="attic"))
    assert Selection(R0, "floor_1", True).settled(state, follow=True).floor == "floor_1"
    silent = reduced(fleet(1, 2), battery(T0))
    assert Selection(R0, "floor_1", True).settled(silent, follow=True).floor == "floor_1"
