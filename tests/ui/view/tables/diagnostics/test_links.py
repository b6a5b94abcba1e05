"""Links on the diagnostics screen: their state, round trips, rates and losses."""

from fleet_tui.model.events import CommandPathChanged
from fleet_tui.model.link import CommandPath
from fleet_tui.text.language import Message
from fleet_tui.ui.view.tables.diagnostics.links import link_table
from tests.support.diagnostics import NOW, POSE, counter, row, seen, text
from tests.support.fleets import LINK, T0, fleet, link_lost, link_up, reduced


def test_a_link_that_is_well() -> None:
    link = counter()
    link.opened()
    for n in range(100):
        link.all.take(300, NOW - (99 - n) / 50)
    for took in (0.001, 0.003, 0.002):
        link.round_trips.take(took, NOW - 1.0)
    table = link_table(seen(link)[1], NOW)
    assert "● up for 20 s" in row(table, "state")
    assert "2.00 ms, 1.0 s ago  last 3: 1.00 ms to 3.00 ms, mean 2.00 ms, jitter 1.50 ms" in row(
        table, "trip"
    )
    assert "▃█▆ up to 3.00 ms" in row(table, "trend")
    assert "50.0 /s, 15.0 kB/s, 100 and 30.0 kB in total" in row(table, "messages  ")
    assert "0 reconnects" in row(table, "connections") and "lost" not in row(table, "connections")
    assert "○ not tried yet" in row(table, "commands")


def test_a_link_that_is_down_says_so_and_since_when_everything_is_old() -> None:
    link = counter()
    link.opened()
    link.all.take(1, T0)
    link.lost("the bridge went away", T0 + 10.0)
    link.dropped, link.unreadable = 2, 1
    link.failed("no JSON", b"{", False, NOW - 3.0)
    link.round_trips.take(0.001, T0)
    link.round_trips.unanswered = 4
    state = reduced(fleet(2), link_up(T0), link_lost(T0 + 10.0, "connection refused", NOW + 3.0))
    table = link_table(seen(link, state)[1], NOW)
    assert "○ no link for 10 s: connection refused, retry in 3 s" in row(table, "state")
    assert "20 s ago" in row(table, "last message")
    assert "overdue" in row(table, "trip") and "4 unanswered" in row(table, "trip")
    assert "last lost 10 s ago: the bridge went away" in row(table, "connections")
    assert "2 frames: too large" in row(table, "dropped")
    assert "2 frames, last 3.0 s ago: no JSON" in row(table, "unreadable")


def test_before_anything_came() -> None:
    link = counter()
    _, links = seen(link)
    table = link_table(links, NOW)
    assert "no heartbeat reply yet" in row(table, "trip") and "never" in row(table, "last message")
    assert not link_table([], NOW).rows


def test_how_many_robots_have_which_rate_if_they_differ() -> None:
    link = counter()
    link.topics[POSE].asked_ms = link.topics["/robot_1/pose"].asked_ms = 1000
    assert not any(" Hz" in line for line in text(link_table(seen(link)[1], NOW)))
    link.topics[POSE].asked_ms = 100
    assert "poses: 1 at 10 Hz, 1 at 1 Hz" in row(link_table(seen(link)[1], NOW), "rates")


def test_commands_of_which_no_node_answers_yet_are_neither_well_nor_dead() -> None:
    link = counter()
    link.round_trips.take(0.001, NOW - 1.0)
    path = CommandPathChanged(LINK, CommandPath.ALIVE, Message("not tried yet: no node answers"), True)
    table = link_table(seen(link, reduced(fleet(2), link_up(T0), path))[1], NOW)
    assert "○ not tried yet: no node answers" in row(table, "commands")


def test_commands_are_not_well_while_the_reply_to_a_heartbeat_is_overdue() -> None:
    link = counter()
    link.round_trips.take(0.001, NOW - 1.0)
    state = reduced(fleet(2), link_up(T0), CommandPathChanged(LINK, CommandPath.ALIVE, Message(""), True))
    assert "● ok" in row(link_table(seen(link, state)[1], NOW), "commands")
    link.round_trips.take(0.001, NOW - 40.0)
    assert "▲ replies late 40 s" in row(link_table(seen(link, state)[1], NOW), "commands")
