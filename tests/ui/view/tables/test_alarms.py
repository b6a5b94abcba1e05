"""Alarms that need an operator, and those not acknowledged yet."""

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import alarm_of, alarm_table, unacknowledged
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.listing import Listing
from tests.support.alarms import without_poses
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    WALL,
    battery,
    fleet,
    link_lost,
    link_up,
    reduced,
    text_of,
    tick,
)


def clock(wall: float) -> str:
    return f"{wall:.0f}"


def texts(state: FleetState) -> list[str]:
    return [text_of(row.runs) for row in alarm_table(state, clock).rows]


def low(at: float = T0, percent: float = 15.0) -> FleetState:
    return reduced(without_poses(fleet()), link_up(T0), battery(at, percent), tick(at))


def test_all_clear() -> None:
    table = alarm_table(fleet(), clock)
    assert (len(table.rows), table.empty, text_of(table.title)) == (0, "all clear", "Alarms")


def test_a_new_alarm_says_who_what_and_since_when() -> None:
    state = low()
    (row,) = alarm_table(state, clock).rows
    assert row.key == (R0, "battery")
    assert text_of(row.runs) == f"▲ new  low    robot_0 battery 15 % {state.wall:.0f}"
    assert text_of(alarm_table(state, clock).title) == "Alarms 1 new"
    assert row.runs[0][1] is StyleRole.WARN
    assert alarm_table(low(percent=5.0), clock).rows[0].runs[0][1] is StyleRole.ALARM


def test_seen_over_and_come_again() -> None:
    state = low()
    state = replace(state, limits=replace(state.limits, latched=("battery",)))
    seen = reduced(state, desk_events.AlarmAcknowledged(R0, "battery"))
    assert texts(seen)[0].startswith("△ seen low    robot_0 battery 15 %")
    assert text_of(alarm_table(seen, clock).title) == "Alarms"
    over = reduced(state, battery(T0 + 1, 60.0), tick(T0 + 1))
    assert texts(over)[0].startswith("▲ new  low    robot_0 battery charging or recovered")
    over = reduced(over, battery(T0 + 4, 60.0), tick(T0 + 4))
    assert texts(over)[0].startswith("▽ over low    robot_0 battery charging or recovered")
    again = reduced(over, battery(T0 + 5, 9.0), tick(T0 + 5))
    assert texts(again)[0] == f"▲ new  medium robot_0 battery 9 % {state.wall:.0f} x2"


def test_the_first_moment_stays_however_long_it_lasts() -> None:
    state = low()
    assert texts(reduced(state, battery(T0 + 99, 15.0), tick(T0 + 99)))[0].endswith(f" {state.wall:.0f}")


def test_no_link_stands_there_with_its_reason_only_while_it_is_so() -> None:
    state = reduced(fleet(), link_lost(T0, "connection refused"), tick(T0 + 60))
    assert "no link: connection refused" in texts(state)[0]
    assert alarm_table(state, clock).rows[0].key == (LINK, "link")
    back = reduced(state, link_up(T0 + 61), tick(T0 + 61))
    assert "rosbridge connected after 60 s" in texts(back)[0], "it was never up before"
    assert texts(back)[0].endswith(f" {WALL + T0 + 60:.0f}")  # it held at the last look before


def test_a_first_connection_that_is_slow_is_no_alarm() -> None:
    state = reduced(fleet(), tick(T0), tick(T0 + 5))
    assert not state.alarms and not reduced(state, link_up(T0 + 5), tick(T0 + 6)).alarms
    assert reduced(state, tick(T0 + 20)).alarms
    refused = reduced(fleet(), link_lost(T0), tick(T0 + 5))
    assert refused.alarms, "with a reason it needs a person at once"


def test_what_nobody_has_seen_stands_first_by_priority_then_age() -> None:
    state = reduced(fleet(4), link_up(T0))
    for n in range(4):
        state = reduced(state, battery(T0 + n, 15.0, f"robot_{n}"), tick(T0 + n))
    state = reduced(state, desk_events.AlarmAcknowledged("robot_0", "battery"))
    state = reduced(state, battery(T0 + 4, 5.0, "robot_3"), tick(T0 + 4))
    order = ["robot_3", "robot_1", "robot_2", "robot_0"]
    assert [row.key for row in alarm_table(state, clock).rows] == [(name, "battery") for name in order]
    assert unacknowledged(state) == [(name, "battery") for name in order[:3]]


def test_what_is_shelved_stands_last_and_is_counted_apart() -> None:
    state = reduced(fleet(2), link_up(T0), battery(T0, 5.0), battery(T0, 15.0, "robot_1"), tick(T0))
    state = reduced(state, desk_events.AlarmShelved(R0, "battery", T0 + 1800))
    assert text_of(alarm_table(state, clock).title) == "Alarms 1 new 1 shelved"
    assert texts(state)[1] == (
        f"◇ shelved until {state.wall + 1800:.0f} medium robot_0 battery 5 % {state.wall:.0f}"
    )


def test_no_alarm_needs_more_than_its_word_in_48_cells() -> None:
    state = reduced(fleet(), link_up(T0), events.ObstacleReported(R0, T0, 44.2), tick(T0))
    (row,) = alarm_table(state, lambda _wall: "12:34:56").rows
    assert text_of(row.runs) == "▲ new  high   robot_0 obstacle 44 s 12:34:56"


def test_an_alarm_that_is_over_leaves_the_pane_unless_its_class_is_latched() -> None:
    state = reduced(low(), battery(T0 + 1, 60.0), tick(T0 + 1))
    assert texts(state)[0].startswith("▲ new  low    robot_0 battery charging or recovered")
    assert alarm_table(state, clock).rows[0].runs[0][1] is StyleRole.DIM  # it is over: never red
    assert texts(reduced(state, battery(T0 + 4, 60.0), tick(T0 + 4))) == []


def test_what_is_over_stands_below_what_holds_whatever_its_priority() -> None:
    state = reduced(fleet(2), link_up(T0))
    state = replace(state, limits=replace(state.limits, latched=("battery",)))
    state = reduced(state, battery(T0, 5.0), tick(T0), battery(T0 + 1, 60.0), tick(T0 + 1), tick(T0 + 5))
    state = reduced(state, battery(T0 + 5, 15.0, "robot_1"), tick(T0 + 5))
    assert [text[:6] for text in texts(state)] == ["▲ new ", "▽ over"]


def test_alarms_that_another_one_stands_for_are_counted() -> None:
    state = reduced(fleet(3), link_lost(T0, "nothing listens there"), tick(T0 + 60))
    assert text_of(alarm_table(state, clock).title) == "Alarms 1 new 3 suppressed"


def test_in_a_narrow_pane_the_reason_stays() -> None:
    state = low()
    row, advice = alarm_table(state, lambda _wall: "12:04:31", 38).rows
    assert text_of(row.runs) == "▲ low  robot_0 battery 15 % 12:04"
    assert text_of(advice.runs) == "  Send it to a charger" and advice.key is None


def test_each_priority_has_its_own_sign_and_colour() -> None:
    lost = reduced(without_poses(fleet()), link_up(T0), link_lost(T0 + 1), tick(T0 + 60))
    for state, sign, role in (
        (lost, "▲ high", StyleRole.ROBOT_ALARM),
        (low(percent=5.0), "▲ med  ", StyleRole.ALARM),
        (low(), "▲ low  ", StyleRole.WARN),
    ):
        assert alarm_table(state, clock, 38).rows[0].runs[0] == (sign, role)
    assert alarm_table(lost, clock, 60).rows[0].runs[0] == ("▲ new  high", StyleRole.ROBOT_ALARM)
    seen = reduced(lost, desk_events.AlarmAcknowledged())
    assert alarm_table(seen, clock, 38).rows[0].runs[0] == ("△ high ", StyleRole.WARN)


def test_of_a_few_alarms_the_marked_one_has_its_advice_below() -> None:
    acknowledged = reduced(low(), desk_events.AlarmAcknowledged(R0, "battery"))
    assert len(alarm_table(acknowledged, clock, 38).rows) == 2
    shelved = reduced(low(), desk_events.AlarmShelved(R0, "battery", T0 + 1800))
    latched = replace(low(), limits=replace(low().limits, latched=("battery",)))
    over = reduced(latched, battery(T0 + 1, 60.0), tick(T0 + 1), tick(T0 + 5))
    assert [len(alarm_table(state, clock, 80).rows) for state in (shelved, over)] == [1, 1]
    two = reduced(fleet(2), link_up(T0), battery(T0, 5.0), battery(T0, 15.0, "robot_1"), tick(T0))
    first, second, advice = alarm_table(two, clock, 38).rows
    assert first.key and second.key and text_of(advice.runs) == "  robot_0: Send it to a charger"
    *_, advice = alarm_table(two, clock, 38, marked=second.key).rows
    assert text_of(advice.runs) == "  robot_1: Send it to a charger"


def test_a_selected_robot_has_its_alarm_marked_but_none_that_needs_nobody_before_others() -> None:
    two = reduced(fleet(3), link_up(T0), battery(T0, 5.0), battery(T0, 15.0, "robot_1"), tick(T0))
    assert [alarm_of(two, name) for name in (R0, "robot_2")] == [(R0, "battery"), None]
    first = reduced(two, desk_events.AlarmAcknowledged(R0, "battery"))
    assert alarm_of(first, R0) is None and alarm_of(first, "robot_1") == ("robot_1", "battery")
    assert alarm_of(reduced(two, desk_events.AlarmAcknowledged()), R0) == (R0, "battery")


def test_a_single_alarm_that_is_cut_goes_on_in_a_second_line() -> None:
    reason = "no route to host 10.11.12.13, asked again and again"
    state = reduced(without_poses(fleet()), link_up(T0), link_lost(T0 + 1, reason), tick(T0 + 60))
    first, second, *_ = alarm_table(state, clock, 38).rows
    assert second.key is None and "again" in text_of(second.runs)
    assert reason not in text_of(first.runs)
    assert reason in text_of(alarm_table(state, clock, 120).rows[0].runs)


def test_a_filter_finds_alarms_by_their_time_of_the_row() -> None:
    arrangement = RowArrangement()
    arrangement.typed = f"time:{low().wall:.0f}"
    table = alarm_table(low(), clock, 80, arrangement)
    assert table.rows[0].key == (R0, "battery") and text_of(table.title).endswith(": 1")
    arrangement.typed = "time:99"
    assert not alarm_table(low(), clock, 80, arrangement).rows


def test_the_second_line_of_an_alarm_is_no_alarm() -> None:
    arrangement = RowArrangement()
    arrangement.typed = "no"
    state = reduced(fleet(), link_lost(T0, "connection refused by the server of this address"), tick(T0 + 60))
    table = alarm_table(state, clock, 40, arrangement)
    assert len(table.rows) > 1 and text_of(table.title).endswith(": 1")
    listing = Listing()
    listing.show(table)
    listing.lines(41, 9, True)
    assert listing.move(1) and listing.cursor == (LINK, "link") and not listing.steps_to(1)


def test_of_a_few_alarms_the_marked_one_has_its_whole_text() -> None:
    reason = "no route to host 10.11.12.13, asked again and again"
    lost = reduced(fleet(), link_up(T0), battery(T0, 5.0), tick(T0), link_lost(T0 + 1, reason), tick(T0 + 60))
    keys = [row.key for row in alarm_table(lost, clock, 38).rows if row.key]
    assert len(keys) > 1
    place = keys.index((LINK, "link"))
    rows = alarm_table(lost, clock, 38, marked=keys[place]).rows
    assert [row.key for row in rows[place : place + 2]] == [keys[place], None]
    assert "again" in text_of(rows[place + 1].runs)
    listing = Listing()
    listing.choose(keys[place])
    listing.show(alarm_table(lost, clock, 38, marked=keys[place]))
    assert reason in listing.text, "copied whole, though the row has its beginning alone"
    rows = alarm_table(lost, clock, 38, marked=keys[1 - place]).rows
    assert not any("again" in text_of(row.runs) for row in rows if row.key is None)


def test_names_of_fleets_are_whole_where_there_is_room_else_the_robots_own_if_it_is_unique() -> None:
    first = fleet().robots[R0]
    named = {
        name: replace(first, name=name) for name in ("carriers/robot_1", "carriers/robot_2", "tiny/robot_2")
    }
    state = reduced(
        replace(fleet(), robots=named), link_up(T0), *(battery(T0, 5.0, one) for one in named), tick(T0)
    )

    def sources(width: int) -> list[str]:
        rows = alarm_table(state, clock, width).rows
        return [
            text_of(row.runs[1:2]).strip() for row in rows if row.key in [one.key for one in state.alarms]
        ]

    assert sources(90) == list(named)
    assert sources(44) == ["robot_1", "carriers/robo…", "tiny/robot_2"]
