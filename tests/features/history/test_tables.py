"""Pages of the history as text."""

from fleet_tui.features.history.events import past_events
from fleet_tui.features.history.shift import ShownShift
from fleet_tui.features.history.tables import (
    alarms_table,
    batteries_table,
    curve_of,
    events_table,
    moment_of,
    robots_table,
)
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.history.lives import AlarmLife, PastOrder
from fleet_tui.model.history.totals import ChargeTotal
from fleet_tui.records.history.division import Division
from fleet_tui.situation.battery.forecast import BatteryForecast
from fleet_tui.text.language import Message
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.table import Table
from tests.support.fleets import text_of

TIME = Division(0.0, 400.0, 4)
ORDER = PastOrder("robot_0", "12", "A -> B", "f", 10.0, 25.0, 85.0, "done", "", "ana")
LOST = PastOrder("robot_1", "13", "-> B", "f", 11.0, None, 95.0, "lost", "left", "")


def clock(at: float) -> str:
    return f"{at:05.0f}"


def lines(table: Table) -> list[str]:
    return [text_of(row.runs) for row in table.rows]


def filtered(typed: str) -> RowArrangement:
    arrangement = RowArrangement()
    arrangement.typed = typed
    return arrangement


def alarm(raised: float, returned: float | None, source: str = "robot_0", count: int = 1) -> AlarmLife:
    return AlarmLife(source, Message("stuck"), "high", "stuck", raised, returned, None, returned, "", count)


def test_events_are_newest_first_and_trouble_is_red() -> None:
    shown = ShownShift(TIME, events=past_events([ORDER, LOST]))
    table = events_table(shown, clock)
    assert lines(table) == [
        "00095  robot_1 order 13 -> B: lost (left)",
        "00085  robot_0 order 12 A -> B: done (waited 15 s, driven in 60 s), by ana",
    ]
    assert [row.runs[-1][1] for row in table.rows] == [StyleRole.ALARM, StyleRole.TEXT]
    assert moment_of(table.rows[0].key) == ("robot_1", 95.0)
    assert lines(events_table(shown, clock, filtered("!lost"))) == lines(table)[1:]
    by_robot = RowArrangement()
    by_robot.column = "robot"
    assert lines(events_table(shown, clock, by_robot)) == lines(table)[::-1]


def test_a_bar_for_each_part_and_a_gap_where_nobody_watched() -> None:
    does = [Activity.DRIVING, Activity.DRIVING, None, Activity.BLOCKED]
    shown = ShownShift(TIME, timeline={"robot_0": does, "robot_1": [None] * 4})
    table = robots_table(shown, clock, is_ascii=False)
    assert lines(table) == ["robot_0 ▆▆ █", "robot_1     "]
    assert text_of(table.title) == "Robots 2  ▆ driving  █ blocked"
    assert lines(robots_table(shown, clock, True, filtered("_0"))) == ["robot_0 == B"]
    assert moment_of(table.rows[0].key) is None


def test_a_battery_has_its_levels_its_curve_and_what_it_leads_to() -> None:
    charges = {"robot_0": [ChargeTotal("robot_0", n, 95.0 - 30 * n, 99.0 - 30 * n) for n in (0, 1, 3)]}
    forecasts = {"robot_0": BatteryForecast(3600.0, None)}
    shown = ShownShift(TIME, charges=charges, forecasts=forecasts)
    assert lines(batteries_table(shown, clock, False, 20.0)) == ["robot_0    9% ▾  5% █▆ ▁ empty in 60 min"]
    assert lines(batteries_table(shown, clock, True, 20.0)) == ["robot_0    9% v  5% 75 0 empty in 60 min"]
    samples = curve_of(charges["robot_0"], TIME)
    assert [(one.at, one.follows) for one in samples] == [(50.0, False), (150.0, True), (350.0, False)]


def test_alarms_are_lines_of_time_the_longest_first() -> None:
    short, long, last = alarm(10.0, 20.0), alarm(110.0, 390.0, "robot_1"), alarm(300.0, None, count=3)
    table = alarms_table(ShownShift(TIME, alarms=[short, long, last]), clock, is_ascii=False)
    assert lines(table) == ["stuck robot_1 once      4 min   ·███", "stuck robot_0 4 times   110 s   █··█"]
    assert moment_of(table.rows[1].key) == ("robot_0", 300.0)
    only = alarms_table(ShownShift(TIME, alarms=[short, long]), clock, True, filtered("robot_0"))
    assert lines(only) == ["stuck robot_0 once      10 s    #..."]


def test_an_empty_page_says_why() -> None:
    shown = ShownShift(TIME)
    assert events_table(shown, clock).empty == "nothing happened in this time"
    assert robots_table(shown, clock, False).empty == "no robot was seen in this time"
    failed = ShownShift(TIME, problem=Message("the history can't be read: "))
    assert alarms_table(failed, clock, False).empty == "the history can't be read: ␛"
