"""Many alarms with one cause are one alarm, at every moment."""

from fleet_tui.model import events
from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import Message
from tests.support.alarms import alarm, up
from tests.support.fleets import LINK, R0, T0, battery, fleet, link_lost, link_up, pose, queue, reduced, tick


def silence(state: FleetState, gone: set[int], robots: int, start: float, seconds: float) -> FleetState:
    """The others speak on; the writer's clock ticks."""
    for n in range(round(seconds * 10)):
        at = start + n / 10
        state = reduced(
            state, *(battery(at, robot=f"robot_{n}") for n in range(robots) if n not in gone), tick(at)
        )
    return state


def offline(state: FleetState) -> list[str]:
    return [one.text for one in state.alarms if one.condition.kind in ("offline", "many offline")]


def test_robots_that_go_together_are_one_alarm_at_every_moment() -> None:
    """100 robots, 37 of them fall silent within two seconds, in no order."""
    state = up(100)
    for n in range(130):
        at = T0 + n / 10
        speak = (k for k in range(100) if k >= 37 or n / 10 <= (k * 7 % 37) / 37 * 2.0)
        state = reduced(state, *(battery(at, robot=f"robot_{k}") for k in speak), tick(at))
        assert len(offline(state)) == (n / 10 > 5.0)
    assert offline(state) == ["37 robots offline: robot_0, robot_1, robot_2, …"]
    assert [one.key for one in state.alarms] == [(LINK, "many offline")]
    assert sum(not state.is_online(robot) for robot in state.robots.values()) == 37


def test_when_a_group_shrinks_its_row_follows() -> None:
    state = silence(up(20), set(range(10)), 20, T0 + 0.1, 8)
    state = reduced(state, desk_events.AlarmAcknowledged())
    state = silence(state, {0, 1}, 20, T0 + 9, 1)
    assert offline(state) == ["2 robots offline: robot_0, robot_1"]
    state = silence(state, {1}, 20, T0 + 10, 1)
    assert offline(state) == ["1 robot offline: robot_1"]
    assert state.unacknowledged == 0
    assert offline(silence(state, set(), 20, T0 + 11, 4)) == []


def test_one_more_robot_after_a_flood_is_an_alarm_of_its_own() -> None:
    state = silence(up(20), set(range(10)), 20, T0 + 0.1, 20)
    state = reduced(state, desk_events.AlarmAcknowledged())
    state = silence(state, set(range(11)), 20, T0 + 20, 8)
    assert offline(state) == ["10 robots offline: robot_0, robot_1, robot_2, …", "offline 8 s"]
    assert state.unacknowledged == 1


def test_a_second_flood_needs_another_look() -> None:
    state = reduced(silence(up(20), set(range(6)), 20, T0 + 0.1, 20), desk_events.AlarmAcknowledged())
    state = silence(state, set(range(12)), 20, T0 + 20, 8)
    assert offline(state) == ["12 robots offline: robot_0, robot_1, robot_2, …"]
    assert state.unacknowledged == 1


def test_few_robots_are_alarms_of_their_own() -> None:
    state = silence(up(20), {3, 4, 5, 6}, 20, T0 + 0.1, 8)
    assert [one.key for one in state.alarms] == [(f"robot_{n}", "offline") for n in (3, 4, 5, 6)]


def test_a_lost_link_is_one_alarm_and_its_robots_no_others() -> None:
    state = reduced(up(100), link_lost(T0 + 1), tick(T0 + 2))
    for n in range(2, 60):
        state = reduced(state, tick(T0 + n))
    assert [one.key for one in state.alarms] == [(LINK, "link")]
    # Back, but nobody speaks.
    state = reduced(state, link_up(T0 + 60), tick(T0 + 60), tick(T0 + 70))
    assert offline(state) == ["100 robots offline: robot_0, robot_1, robot_2, …"]


def test_a_console_that_slept_finds_one_alarm() -> None:
    assert offline(reduced(up(100), tick(T0 + 600))) == ["100 robots offline: robot_0, robot_1, robot_2, …"]


def test_robots_that_were_never_heard_are_not_said_to_have_gone() -> None:
    state = reduced(fleet(10), link_up(T0), tick(T0 + 6))
    assert offline(state) == ["10 robots never seen: robot_0, robot_1, robot_2, …"]


def test_a_fleet_that_is_paused_for_long_is_one_alarm() -> None:
    state = up(100)
    for n in range(310):
        speak = (events.PausedReported(f"robot_{k}", T0 + n + k / 100, True) for k in range(100))
        state = reduced(state, *speak, tick(T0 + n + 1))
    assert [(one.key, one.text) for one in state.alarms] == [
        ((LINK, "many pause"), "100 robots in a long pause: robot_0, robot_1, robot_2, …")
    ]


def test_bad_data_of_all_robots_is_one_alarm() -> None:
    state = up(100)
    for n in range(100):
        state = reduced(state, events.MessageRejected(f"robot_{n}", Message("pose: no x")), tick(T0 + n / 50))
    state = reduced(state, tick(T0 + 3.5))
    assert [one.text for one in state.alarms] == ["100 robots with bad data: robot_0, robot_1, robot_2, …"]


def test_a_fleet_that_stops_at_once_is_one_alarm() -> None:
    state = up(10)
    for n in range(70):
        for k in range(10):
            name = f"robot_{k}"
            waits = queue(T0 + n, (12, 1, 2, "W"), current=12, robot=name)
            state = reduced(state, pose(T0 + n, robot=name), waits)
        state = reduced(state, tick(T0 + n))
    assert [one.key for one in state.alarms] == [(LINK, "many stuck")]


def test_a_shelved_robot_is_not_taken_into_a_group() -> None:
    state = silence(up(20), {0}, 20, T0 + 0.1, 8)
    state = reduced(state, desk_events.AlarmShelved(R0, "offline", T0 + 1000))
    state = silence(state, set(range(10)), 20, T0 + 9, 8)
    assert [(one.key, one.stage) for one in state.alarms] == [
        ((R0, "offline"), AlarmStage.SHELVED),
        ((LINK, "many offline"), AlarmStage.UNACKNOWLEDGED),
    ]
    assert alarm(state, "many offline", LINK).text.startswith("9 robots offline")
    assert (state.unacknowledged, state.shelved) == (1, 1)


def test_a_fleet_without_poses_is_one_alarm() -> None:
    speak = [battery(T0 + second, robot=f"robot_{n}") for second in range(9) for n in range(6)]
    state = fleet(6)
    for second in range(9):
        state = reduced(state, link_up(T0), *speak[second * 6 : second * 6 + 6], tick(T0 + second))
    (one,) = state.alarms
    assert one.key == (LINK, "many localisation")
    assert one.text == "6 robots with an uncertain position: robot_0, robot_1, robot_2, …"
