"""The line that is always in view tells the link, the alarms and how commands ended."""

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Link, RobotEntry
from fleet_tui.config.start import initial_state
from fleet_tui.keys import keymap
from fleet_tui.model import events
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    Outcome,
    PauseRobot,
    PlaceOrder,
    PlaceOrderWithCargo,
    ResumeRobot,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.view.hints import hints
from fleet_tui.view.roles import Ink
from fleet_tui.view.status_line import command_text, message_line, status_line
from tests.fleets import (
    LINK,
    R0,
    T0,
    WALL,
    battery,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    text_of,
    tick,
    told,
)
from tests.watched import config_of


def line(state: FleetState, *notes: str) -> str:
    return text_of(status_line(state, R0, notes))


def test_no_link_says_why_since_when_and_when_it_is_tried_next() -> None:
    state = told(fleet(), link_up(T0), link_lost(T0 + 10, "nothing listens there", T0 + 14), tick(T0 + 12))
    assert "○ no link ws://site:9090 nothing listens there, next try 2 s, since 2 s" in line(state)
    assert {ink for text, ink in status_line(state, R0) if "no link" in text} == {Ink.ALARM}
    assert "next try 0 s" in line(told(state, tick(T0 + 20)))
    trying = told(state, events.LinkChanged(LINK, T0 + 14, Phase.CONNECTING), tick(T0 + 15))
    assert "nothing listens there, trying now, since 5 s" in line(trying)


def test_before_the_first_connection() -> None:
    assert "no link ws://site:9090 trying now, since 3 s" in line(told(fleet(), tick(T0 + 3)))


def test_a_link_shows_the_age_of_the_last_message() -> None:
    state = told(fleet(), link_up(T0), tick(T0 + 1))
    assert "● ws://site:9090 nothing heard yet" in line(state)
    assert "● ws://site:9090 0.4 s" in line(told(state, events.LinkHeard(LINK, T0 + 2), tick(T0 + 2.4)))
    assert "no link" not in line(state)


def test_telemetry_alive_and_commands_dead() -> None:
    dead = events.CommandPathChanged(LINK, CommandPath.DEAD, "the ROS master is gone")
    state = told(fleet(), link_up(T0), events.LinkHeard(LINK, T0), dead, tick(T0))
    assert "commands dead: the ROS master is gone" in line(state) and "● " in line(state)
    assert "commands dead" not in line(told(state, events.CommandPathChanged(LINK, CommandPath.ALIVE)))
    assert "no link" in line(told(state, link_lost(T0 + 1))) and "dead" not in line(
        told(state, link_lost(T0 + 1))
    )


def test_bad_frames_are_counted() -> None:
    state = told(fleet(), link_up(T0), events.FrameRejected(LINK, "x"), events.FrameRejected(LINK, "x"))
    assert "2 bad frames" in line(state)


def test_of_several_links_the_worst_is_shown() -> None:
    config = replace(config_of("ws://a:1", 2), links={"b": Link("ws://b:2")})
    state = initial_state(replace(config, robots=[RobotEntry(R0), RobotEntry("robot_1", link="b")]), T0)
    up = (link_up(T0), events.LinkChanged("b", T0, Phase.UP))
    assert "2 of 2 links up" in line(told(state, *up))
    lost = told(state, *up, events.LinkChanged("b", T0 + 1, Phase.WAITING, "it closed"), tick(T0 + 1))
    assert "no link ws://b:2 it closed" in line(lost) and "1 of 2 links up" in line(lost)
    dead = told(state, *up, events.CommandPathChanged("b", CommandPath.DEAD, "gone"), tick(T0 + 1))
    assert "ws://b:2" in line(dead) and "commands dead: gone" in line(dead)
    quiet = told(state, *up, events.LinkHeard("b", T0), events.LinkHeard(LINK, T0 + 9), tick(T0 + 9))
    assert "ws://b:2 9.0 s" in line(quiet)
    assert "links up" not in line(fleet())


@pytest.mark.parametrize(
    ("low", "seen", "text"),
    [
        (0, 0, "△ 0 alarms  "),
        (1, 0, "▲ 1 alarm (1 new)"),
        (3, 1, "▲ 3 alarms (2 new)"),
        (2, 2, "△ 2 alarms  "),
    ],
)
def test_alarms_are_counted_and_the_new_ones_apart(low: int, seen: int, text: str) -> None:
    state = told(fleet(4), *(battery(T0, 5.0, f"robot_{n}") for n in range(low)), tick(T0))
    state = told(state, *(events.AlarmAcknowledged(f"robot_{n}", "battery") for n in range(seen)))
    assert text in line(state)


def test_what_must_not_be_cut_stands_first() -> None:
    text = line(told(fleet(), link_lost(T0), tick(T0)), "read-only")
    assert text.index(R0) < text.index("alarms") < text.index("read-only") < text.index("no link")


COMMANDS: list[tuple[Command, str]] = [
    (PlaceOrder(R0, 1, 2), "robot_0 order Base -> 2"),
    (PlaceOrder(R0, 1, 77), "robot_0 order Base -> 77?"),
    (PlaceOrderWithCargo(R0, 1), "robot_0 bring cargo -> Base"),
    (CancelOrder(R0, 7), "robot_0 cancel order 7"),
    (ClearOrders(R0), "robot_0 clear all orders"),
    (PauseRobot(R0), "robot_0 pause"),
    (ResumeRobot(R0), "robot_0 resume"),
]


@pytest.mark.parametrize(("command", "text"), COMMANDS, ids=[text for _, text in COMMANDS])
def test_commands_in_the_operators_words(command: Command, text: str) -> None:
    assert command_text(told(fleet(), graph(1, 2), labels({1: "Base"})), command) == text


def issued(id_: int, at: float, robot: str = R0) -> events.CommandIssued:
    return events.CommandIssued(id_, PauseRobot(robot), at, WALL)


@pytest.mark.parametrize(
    ("outcome", "words", "said", "ink"),
    [
        (Outcome.ACCEPTED, "paused", ": accepted", Ink.GOOD),
        (Outcome.ACCEPTED, "ACCEPTED", ": accepted", Ink.GOOD),
        (Outcome.REFUSED, "REJECTED: no", ": refused (REJECTED: no)", Ink.ALARM),
        (Outcome.NO_ANSWER, "within 5 s", ": no answer (within 5 s)", Ink.ALARM),
        (Outcome.NOT_SENT, "", ": not sent", Ink.ALARM),
    ],
)
def test_how_a_command_ended(outcome: Outcome, words: str, said: str, ink: Ink) -> None:
    state = told(fleet(), issued(1, T0), events.CommandFinished(1, outcome, words), tick(T0 + 3))
    runs = message_line(state, "", 0.0)
    assert text_of(runs) == f" robot_0 pause{said}"
    assert {found for text, found in runs if outcome.value in text} == {ink}


def test_a_command_under_way_shows_how_long() -> None:
    state = told(fleet(), issued(1, T0), tick(T0 + 3))
    assert text_of(message_line(state, "", 0.0)) == " robot_0 pause: sent 3 s ago"


def test_the_newest_word_is_shown_and_commands_given_together_stand_together() -> None:
    assert message_line(fleet(), "", 0.0) == ()
    assert text_of(message_line(fleet(), "no order here", T0)) == " no order here"
    state = told(fleet(3), issued(1, T0), *(issued(2 + n, T0 + 10, f"robot_{n}") for n in range(3)))
    bad = events.CommandFinished(4, Outcome.REFUSED, "no")
    state = told(state, bad, events.CommandFinished(2, Outcome.ACCEPTED), tick(T0 + 10))
    text = text_of(message_line(state, "older", T0 + 9))
    assert text.count("pause") == 3 and "older" not in text
    assert text.index("robot_2") < text.index("robot_0")  # what went wrong must not be cut off
    # A command that ended badly stays in view, whatever is said or given after it.
    newer = text_of(message_line(told(state, issued(9, T0 + 12)), "newer", T0 + 11))
    assert "robot_2 pause: refused (no)" in newer and "newer" not in newer
    later = told(state, issued(9, T0 + 12), tick(T0 + 41))
    assert "refused" not in text_of(message_line(later, "", 0.0))


def test_pause_all_of_a_large_fleet_is_one_word() -> None:
    state = told(fleet(9), *(issued(n, T0, f"robot_{n}") for n in range(9)))
    state = told(state, *(events.CommandFinished(n, Outcome.NOT_SENT, "no link") for n in range(9)))
    text = text_of(message_line(state, "", 0.0))
    assert text == " robot_0 pause and 8 more like it: not sent (no link)"


@pytest.mark.parametrize("pane", ["map", "table"])
def test_hints_show_the_keys_as_they_are_set(pane: str) -> None:
    chosen, problems = keymap({"order": "O", "menu": "home"})
    left, right = hints(chosen, pane)
    assert problems == []
    assert " O order " in text_of(left) and " ? help " in text_of(right) and " : command " in text_of(right)
    assert (" home menu " in text_of(left)) is (pane == "table")
    assert text_of(left).startswith(" home menu " if pane == "table" else " ] robot ")
