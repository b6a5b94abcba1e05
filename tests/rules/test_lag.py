"""Lag: what this console has not read yet, and what the bridge delivers late, are told apart."""

from fleet_tui.model.alarm import Priority
from fleet_tui.model.events import CommandPathChanged, Event, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.view.tables.alarms import alarm_table
from tests.support.fleets import LINK, R0, T0, WALL, battery, fleet, link_up, pose, queue, reduced, text_of


def tick(at: float, behind: float = 0.0) -> TimePassed:
    return TimePassed(at, WALL + at, behind)


def driving(late: float, unread: float) -> FleetState:
    """A robot whose poses come ever later, until they are `late` seconds old when they are read."""
    facts: list[Event] = [link_up(T0), pose(T0, stamp=50.0), queue(T0), battery(T0), tick(T0)]
    for n in range(1, 200):
        at = T0 + n * 0.1
        lag = min(late, n * 0.05)
        facts += [pose(at, stamp=50.0 + at - T0 - lag), tick(at, min(unread, lag))]
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
    assert "offline" in kinds(reduced(state, tick(state.now + 60.0))), "nothing arrives any more"


def test_lost_replies_are_those_of_a_late_bridge() -> None:
    dead = CommandPathChanged(LINK, CommandPath.DEAD, "no reply within 5 s")
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


def test_a_moment_is_no_lag() -> None:
    assert kinds(driving(late=0.5, unread=0.4)) == set()


def test_when_it_keeps_up_again_everything_is_as_it_was() -> None:
    state = driving(late=9.0, unread=2.0)
    at = T0 + 20.0
    state = reduced(state, pose(at, stamp=70.0), queue(at), battery(at), tick(at))
    state = reduced(state, pose(at + 4, stamp=74.0), queue(at + 4), battery(at + 4), tick(at + 4))
    assert state.behind == 0.0 and kinds(state) == set()
    gone = reduced(state, tick(at + 10))
    assert not gone.is_online(gone.robots[R0])
