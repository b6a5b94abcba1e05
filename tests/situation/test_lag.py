"""Lag: what this console has not read yet, and what the bridge delivers late, are told apart."""

from fleet_tui.model.alarm import Priority
from fleet_tui.model.events import BridgeAnswered, CommandPathChanged, Event, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.situation.alarms.trouble import is_odd
from fleet_tui.text.language import Message
from fleet_tui.ui.view.tables.alarms import alarm_table
from tests.support.alarms import up
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    WALL,
    battery,
    fleet,
    link_lost,
    link_up,
    pose,
    queue,
    reduced,
    text_of,
)


def tick(at: float, behind: float = 0.0) -> TimePassed:
    return TimePassed(at, WALL + at, behind)


def driving(late: float, unread: float) -> FleetState:
    """A robot whose poses, and the answers of its bridge, come ever later: at last `late` seconds."""
    facts: list[Event] = [link_up(T0), pose(T0, stamp=50.0), queue(T0), battery(T0), tick(T0)]
    for n in range(1, 200):
        at = T0 + n * 0.1
        lag = min(late, n * 0.06)
        facts += [
            pose(at, stamp=50.0 + at - T0 - lag),
            BridgeAnswered(LINK, at, lag),
            tick(at, min(unread, lag)),
        ]
    return reduced(fleet(), *facts)


def kinds(state: FleetState) -> set[str]:
    return {alarm.condition.kind for alarm in state.alarms if alarm.holds}


def test_what_comes_late_while_this_console_keeps_up_is_the_bridges_doing() -> None:
    state = driving(late=3.0, unread=0.0)
    assert (round(state.links[LINK].late, 1), state.behind) == (3.0, 0.0)
    (alarm,) = [alarm for alarm in state.alarms if alarm.condition.kind == "late"]
    assert alarm.text.startswith("messages 3.0 s late: bridge overloaded")


def test_robots_behind_a_late_bridge_are_in_its_alarm_and_not_blamed() -> None:
    state = driving(late=9.0, unread=0.0)
    assert not state.is_online(state.robots[R0]) and kinds(state) == {"late"}
    (alarm,) = state.alarms
    assert alarm.text.startswith("messages 9.0 s late, 1 robot silent: bridge overloaded")
    assert alarm.condition.priority is Priority.HIGH
    assert "1 suppressed" in text_of(alarm_table(state, str).title)


def standing(seconds: float, silent_from: float = 1e9) -> FleetState:
    """Two robots that stand and repeat their last pose with its old stamp; the bridge answers at once. One of
    them loses power."""
    state = reduced(up(2), BridgeAnswered(LINK, T0, 0.004))
    for n in range(round(seconds * 10)):
        at = T0 + n / 10
        speaking = [R0, "robot_1"] if at < T0 + silent_from else [R0]
        state = reduced(state, *(pose(at, stamp=50.0, robot=name) for name in speaking))
        if n % 20 == 0:
            state = reduced(state, BridgeAnswered(LINK, at, 0.004))
        state = reduced(state, tick(at))
    return state


def test_old_stamps_of_standing_robots_are_no_fault_of_the_bridge() -> None:
    state = standing(16.0)
    assert state.links[LINK].late == 0.0 and kinds(state) == set()
    assert all(map(state.is_online, state.robots.values()))


def test_a_standing_robot_that_repeats_its_pose_is_calm_and_one_with_an_order_is_not() -> None:
    state = reduced(fleet(), link_up(T0), BridgeAnswered(LINK, T0, 0.004))
    for n in range(500):
        at = T0 + n / 10
        state = reduced(state, pose(at, stamp=50.0), queue(at), battery(at), tick(at))
    assert state.is_old(state.robots[R0], "pose") and not state.alarms
    assert not is_odd(state, state.robots[R0])
    state = reduced(state, queue(state.now, (1, 1, 2, "W"), current=1), tick(state.now))
    assert [alarm.text for alarm in state.alarms] == ["poses arrive 50 s old"]


def test_a_robot_that_loses_power_beside_old_stamps_is_told() -> None:
    state = standing(30.0, silent_from=20.0)
    (alarm,) = state.alarms
    assert (alarm.condition.source, alarm.condition.kind) == ("robot_1", "offline")


def test_late_poses_of_one_robot_concern_that_robot() -> None:
    """Its localisation is slow: its poses are 9 s old; neither its bridge nor the other robot is."""
    state = reduced(fleet(2), link_up(T0), BridgeAnswered(LINK, T0, 0.004))
    for n in range(300):
        at, lag = T0 + n / 10, min(9.0, n * 0.05)
        state = reduced(state, pose(at, stamp=at - lag), pose(at, stamp=at, robot="robot_1"), tick(at))
    assert state.links[LINK].late == 0.0 and "late" not in kinds(state)
    assert state.is_online(state.robots[R0]) and state.is_old(state.robots[R0], "pose")
    assert not state.is_old(state.robots["robot_1"], "pose")


def test_an_overload_never_silences_a_robot_that_stopped_speaking() -> None:
    """The bridge is 3 s late: a robot without a message for longer than its limit and that is told."""
    state = reduced(up(2), BridgeAnswered(LINK, T0, 3.0), tick(T0))
    for n in range(1, 200):
        at = T0 + n / 10
        state = reduced(state, battery(at), BridgeAnswered(LINK, at, 3.0), tick(at))
        offline = ("robot_1", "offline") in {alarm.key for alarm in state.alarms}
        assert offline is (at > T0 + 5.0 + 3.0), at
    assert "late" in kinds(state)


def test_lost_replies_are_those_of_a_late_bridge() -> None:
    dead = CommandPathChanged(LINK, CommandPath.DEAD, Message("no reply within 5 s"))
    state = driving(late=3.0, unread=0.0)
    (alarm,) = reduced(state, dead, tick(state.now)).alarms
    assert alarm.text.startswith("messages 3.0 s late, no reply to commands: bridge overloaded")
    on_time = reduced(driving(late=0.0, unread=0.0), dead, tick(T0 + 20.0))
    assert kinds(on_time) == {"commands"}


def test_what_waits_here_to_be_read_is_this_consoles_doing() -> None:
    state = driving(late=9.0, unread=2.0)
    assert state.links[LINK].late == 0.0 and round(state.behind, 1) == 9.0
    assert kinds(state) == {"behind"}  # and the robot is neither offline nor is its pose old
    assert state.is_online(state.robots[R0]) and state.robots[R0].pose is not None
    assert not state.is_old(state.robots[R0], "pose")


def test_an_answer_that_waited_while_this_console_stood_says_nothing_about_the_bridge() -> None:
    """The console was stopped for 20 s: the answer to a question from before arrives with the first tick."""
    state = reduced(up(), BridgeAnswered(LINK, T0, 0.01), tick(T0))
    state = reduced(state, tick(T0 + 20.0, 20.0), BridgeAnswered(LINK, T0 + 20.01, 19.5))
    state = reduced(state, battery(T0 + 20.05), tick(T0 + 20.1))
    assert state.behind == 0.0 and state.links[LINK].late == 0.0
    state = reduced(state, BridgeAnswered(LINK, T0 + 22.5, 2.0), tick(T0 + 22.5))
    assert state.links[LINK].late == 2.0, "that one was asked afterwards"


def test_a_moment_is_no_lag() -> None:
    assert kinds(driving(late=0.5, unread=0.4)) == set()


def test_when_it_keeps_up_again_everything_is_as_it_was() -> None:
    state = driving(late=9.0, unread=2.0)
    at = T0 + 20.0
    state = reduced(state, pose(at, stamp=70.0), queue(at), battery(at), BridgeAnswered(LINK, at, 0.01))
    state = reduced(state, tick(at))
    state = reduced(state, pose(at + 4, stamp=74.0), queue(at + 4), battery(at + 4), tick(at + 4))
    assert state.behind == 0.0 and kinds(state) == set()
    gone = reduced(state, tick(at + 10))
    assert not gone.is_online(gone.robots[R0])


def test_a_new_connection_has_no_lateness_of_the_last_one() -> None:
    state = driving(late=3.0, unread=0.0)
    state = reduced(state, link_lost(T0 + 20.0), link_up(T0 + 21.0), tick(T0 + 21.0))
    assert state.links[LINK].late == 0.0
