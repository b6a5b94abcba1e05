"""The line that is always in view tells the link, the alarms and how commands ended."""

import pytest
from msgspec.structs import replace

from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.schema import Link
from fleet_tui.config.start import initial_state
from fleet_tui.model import events
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import PAUSE, Kind
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.text.language import Message
from fleet_tui.ui.view.lines.status import console_notes, status_line
from fleet_tui.ui.view.roles import StyleRole
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    battery,
    fleet,
    link_lost,
    link_up,
    of_kinds,
    pose,
    reduced,
    text_of,
    tick,
)
from tests.support.watched_store import config_of


def line(state: FleetState, *notes: str) -> str:
    return text_of(status_line(state, R0, notes))


def test_no_link_says_why_since_when_and_when_it_is_tried_next() -> None:
    state = reduced(fleet(), link_up(T0), link_lost(T0 + 10, "connection refused", T0 + 14), tick(T0 + 12))
    assert "○ no link for 2 s, retry in 2 s: connection refused ws://site:9090" in line(state)
    assert {role for text, role in status_line(state, R0) if "no link" in text} == {StyleRole.ALARM}
    assert "retry in 0 s" in line(reduced(state, tick(T0 + 20)))
    trying = reduced(state, events.LinkChanged(LINK, T0 + 14, Phase.CONNECTING), tick(T0 + 15))
    assert "no link for 5 s, connecting: connection refused" in line(trying)


def test_before_the_first_connection() -> None:
    assert "no link for 3 s, connecting ws://site:9090" in line(reduced(fleet(), tick(T0 + 3)))
    refused = reduced(fleet(), link_lost(T0 + 0.1, "connection refused", T0 + 4), tick(T0 + 3))
    assert "no link for 3 s, retry in 1 s: connection refused ws://site:9090" in line(refused)


@pytest.mark.parametrize("before", [(), (link_lost(T0 + 0.1, "connection refused", T0 + 1),)])
def test_the_first_seconds_of_connecting_are_no_trouble(before: tuple[events.Event, ...]) -> None:
    state = reduced(fleet(), *before, tick(T0 + 1.9))
    assert "○ connecting ws://site:9090" in line(state) and "no link" not in line(state)
    assert {role for _, role in status_line(state, R0)}.isdisjoint({StyleRole.ALARM, StyleRole.WARN})
    assert ("connection refused" in line(state)) is bool(before)
    assert "no link for 2 s" in line(reduced(state, tick(T0 + 2.1)))


def test_a_link_that_is_lost_is_trouble_at_once() -> None:
    state = reduced(fleet(), link_up(T0), link_lost(T0 + 0.5, "it closed"), tick(T0 + 0.6))
    assert "no link for 0 s, connecting: it closed" in line(state)


def test_a_link_shows_the_age_of_the_last_message() -> None:
    state = reduced(fleet(), link_up(T0), tick(T0 + 1))
    assert "● ws://site:9090 nothing received yet" in line(state)
    assert "● ws://site:9090 0.4 s" in line(
        reduced(state, events.MessageArrived(LINK, T0 + 2), tick(T0 + 2.4))
    )
    assert "no link" not in line(state)


def test_telemetry_alive_and_commands_dead() -> None:
    dead = events.CommandPathChanged(LINK, CommandPath.DEAD, Message("no ROS master"))
    state = reduced(fleet(), link_up(T0), events.MessageArrived(LINK, T0), dead, tick(T0))
    assert "commands dead: no ROS master" in line(state) and "● " in line(state)
    assert "commands dead" not in line(reduced(state, events.CommandPathChanged(LINK, CommandPath.ALIVE)))
    assert "no link" in line(reduced(state, link_lost(T0 + 1))) and "dead" not in line(
        reduced(state, link_lost(T0 + 1))
    )


def test_bad_frames_are_counted() -> None:
    state = reduced(fleet(), link_up(T0), events.FrameRejected(LINK, "x"), events.FrameRejected(LINK, "x"))
    assert "2 bad frames" in line(state)


def test_of_several_links_the_worst_is_shown() -> None:
    config = replace(config_of("ws://a:1", 2), links={"b": Link("ws://b:2")})
    state = initial_state(replace(config, robots=[RobotEntry(R0), RobotEntry("robot_1", link="b")]), T0)
    up = (link_up(T0), events.LinkChanged("b", T0, Phase.UP))
    assert "2 of 2 links up" in line(reduced(state, *up))
    lost = reduced(
        state, *up, events.LinkChanged("b", T0 + 1, Phase.WAITING, Message("it closed")), tick(T0 + 1)
    )
    assert "no link for 0 s, connecting: it closed ws://b:2" in line(lost) and "1 of 2 links up" in line(lost)
    dead = reduced(
        state, *up, events.CommandPathChanged("b", CommandPath.DEAD, Message("gone")), tick(T0 + 1)
    )
    assert "ws://b:2" in line(dead) and "commands dead: gone" in line(dead)
    quiet = reduced(
        state, *up, events.MessageArrived("b", T0), events.MessageArrived(LINK, T0 + 9), tick(T0 + 9)
    )
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
    state = reduced(fleet(4), *(battery(T0, 5.0, f"robot_{n}") for n in range(low)), tick(T0))
    state = reduced(state, *(desk_events.AlarmAcknowledged(f"robot_{n}", "battery") for n in range(seen)))
    assert text in line(state)


def test_a_shelved_alarm_is_not_counted() -> None:
    state = reduced(fleet(), link_up(T0), battery(T0, 5.0), tick(T0))
    assert "△ 0 alarms  " in line(reduced(state, desk_events.AlarmShelved(R0, "battery", T0 + 9)))


def test_what_must_not_be_cut_stands_first() -> None:
    text = line(reduced(fleet(), link_up(T0), link_lost(T0), tick(T0)), "read-only")
    assert text.index(R0) < text.index("alarms") < text.index("read-only") < text.index("no link")


def test_a_calm_console_says_nothing() -> None:
    assert console_notes(fleet(), read_only=False, armed=True, standstill=0.1) == []


def test_what_holds_is_said() -> None:
    assert console_notes(fleet(), read_only=True, armed=False, standstill=0.0) == ["read-only", "not armed"]


def test_a_console_gone_blind_says_so() -> None:
    (busy,) = console_notes(fleet(), read_only=False, armed=True, standstill=7.2)
    (hung,) = console_notes(fleet(), read_only=False, armed=True, standstill=12.3)
    assert (busy, hung) == ("no updates for 7 s", "no updates for 12 s: restart this console")


def test_several_paused_robots_are_counted_until_one_is_left() -> None:
    alive = [battery(T0, robot=f"robot_{n}") for n in range(3)]
    paused = [events.PausedReported(f"robot_{n}", T0, True) for n in range(3)]
    some = reduced(fleet(3), link_up(T0), *alive, *paused[:2], tick(T0))
    assert console_notes(some, read_only=False, armed=True, standstill=0.0) == ["2 of 3 PAUSED"]
    one = reduced(fleet(3), link_up(T0), *alive, paused[0], tick(T0))
    assert console_notes(one, read_only=False, armed=True, standstill=0.0) == []


def test_it_says_when_all_robots_are_paused() -> None:
    paused = [events.PausedReported(f"robot_{n}", T0, True) for n in range(2)]
    alive = [battery(T0, robot=f"robot_{n}") for n in range(2)]
    one = reduced(fleet(2), link_up(T0), *alive, paused[0], tick(T0))
    assert "ALL PAUSED" not in console_notes(one, read_only=False, armed=True, standstill=0.0)
    heard = reduced(fleet(2), link_up(T0), alive[0], paused[0], tick(T0))
    assert console_notes(heard, read_only=False, armed=True, standstill=0.0) == ["1 of 2 PAUSED"]
    both = reduced(one, paused[1], tick(T0))
    assert console_notes(both, read_only=False, armed=True, standstill=0.0) == ["ALL PAUSED"]


def test_beside_a_robot_whose_kind_has_no_pause_not_all_are_paused() -> None:
    paused = [events.PausedReported(f"robot_{n}", T0, True) for n in range(2)]
    alive = [battery(T0, robot=f"robot_{n}") for n in range(3)]
    able = next(iter(fleet().robots.values())).kind
    kinds = (able, able, Kind("made up"))
    assert able.can(PAUSE) and not kinds[2].can(PAUSE)
    state = reduced(of_kinds(fleet(3), *kinds), link_up(T0), *alive, *paused, tick(T0))
    assert console_notes(state, read_only=False, armed=True, standstill=0.0) == ["2 of 3 PAUSED"]


def test_a_long_start_tells_how_far_it_is() -> None:
    begun = events.SubscriptionsAdvanced(LINK, T0 + 1, 50, 900)
    state = reduced(fleet(), link_up(T0), begun, tick(T0 + 1))
    assert "subscribing: 50 of 900 topics" in line(state)
    assert "subscribing" not in line(reduced(state, events.SubscriptionsAdvanced(LINK, T0 + 9, 900, 900)))


def test_of_several_links_the_one_with_most_to_subscribe_is_shown() -> None:
    config = config_of("ws://one:9090", 2)
    robots = [config.robots[0], RobotEntry("robot_1", link="two")]
    state = initial_state(replace(config, robots=robots, links={"two": Link("ws://two:9090")}), T0)
    state = reduced(state, link_up(T0), events.LinkChanged("two", T0, Phase.UP))
    advanced = [
        events.SubscriptionsAdvanced(name, T0, 50, total) for name, total in ((LINK, 50), ("two", 90))
    ]
    assert "ws://two:9090 nothing received yet subscribing: 50 of 90" in line(reduced(state, *advanced))


def test_no_young_age_is_beside_the_address_of_a_late_bridge() -> None:
    state = reduced(fleet(), link_up(T0), tick(T0 + 1))
    link = replace(state.links[LINK], last_received=T0 + 1)
    assert line(replace(state, links={LINK: link})).endswith("ws://site:9090 0.0 s")
    late = replace(state, links={LINK: replace(link, late=9.0)})
    assert line(late).endswith("● 9.0 s late: bridge overloaded ws://site:9090 ")


KEPT = (
    "audit: not written: [Errno 13] Permission denied: '/home/operator/.local/state/fleet-tui/audit.jsonl'",
    "last minutes not kept: Permission denied: '/home/operator/.local/state/fleet-tui/recordings'",
    "history: not written: unable to open database file",
)


@pytest.mark.parametrize("width", [80, 120, 180])
def test_notes_on_files_never_push_the_link_out(width: int) -> None:
    state = reduced(fleet(), link_up(T0), events.MessageArrived(LINK, T0 + 1), tick(T0 + 1))
    shown = text_of(status_line(state, R0, ["not armed"], kept=KEPT, width=width))
    assert shown.endswith("● ws://site:9090 0.0 s") and len(shown) <= width
    assert "not armed" in shown and "audit: not written" in shown and "/home" not in shown
    assert "/home/operator" in text_of(status_line(state, R0, kept=KEPT, width=400)), "all of it has space"


@pytest.mark.parametrize("width", [80, 120, 180])
@pytest.mark.parametrize("phase", [Phase.UP, Phase.WAITING])
def test_nor_do_notes_on_this_console(width: int, phase: Phase) -> None:
    state = reduced(fleet(), link_up(T0 - 60), events.MessageArrived(LINK, T0), tick(T0))
    dead = events.CommandPathChanged(
        LINK, CommandPath.DEAD, Message("no reply from the bridge to calls"), True
    )
    state = reduced(state, dead, tick(T0 + 1))
    if phase is Phase.WAITING:
        lost = events.LinkChanged(LINK, T0 + 1, Phase.WAITING, Message("no answer from the server"), T0 + 4)
        state = reduced(state, lost, tick(T0 + 30))
    notes = ["ALL PAUSED, R resumes all", "read-only", "not armed", "this console is 12 s behind"]
    shown = text_of(status_line(state, R0, notes, kept=KEPT, width=width))[:width]
    assert ("no link for 29 s" if phase is Phase.WAITING else " 1.0 s") in shown and "ALL PAUSED" in shown


def test_a_long_address_is_cut_before_the_age_of_the_link() -> None:
    state = reduced(fleet(), link_up(T0), events.MessageArrived(LINK, T0 + 1), tick(T0 + 1))
    link = replace(state.links[LINK], url=f"wss://{'bridge.' * 12}example.org:9090")
    shown = text_of(status_line(replace(state, links={LINK: link}), R0, kept=KEPT, width=80))
    assert "● wss://bridge." in shown and shown.endswith(" 0.0 s") and len(shown) <= 80


def test_a_robot_that_drives_on_though_it_was_paused_is_not_among_the_paused() -> None:
    paused = [events.PausedReported(f"robot_{n}", T0, True) for n in range(2)]
    alive = [battery(T0, robot=f"robot_{n}") for n in range(2)]
    moves = [pose(T0 - 1 + n / 10, n / 10, robot="robot_1") for n in range(11)]
    state = reduced(fleet(2), link_up(T0 - 2), *alive, *moves, *paused, tick(T0))
    assert console_notes(state, read_only=False, armed=True, standstill=0.0) == []
    stands = [pose(T0 + n / 10, 1.0, robot="robot_1") for n in range(1, 12)]
    later = reduced(state, *stands, tick(T0 + 1.2))
    assert console_notes(later, read_only=False, armed=True, standstill=0.0) == ["ALL PAUSED"]
