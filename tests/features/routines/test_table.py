"""The list of routines."""

from fleet_tui.features.routines.lane import Gate, Lane, LanePhase
from fleet_tui.features.routines.page import routine_table, text_table
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.text.language import Message
from fleet_tui.ui.view.tables.table import Table
from tests.support.fleets import text_of
from tests.support.routines import plan_of

PLANS = {"robot_0": plan_of("go Base"), "robot_1": plan_of("wait 5 s")}
RUNS = (
    Lane("robot_0", phase=LanePhase.ORDERED),
    Lane("robot_1", gate=Gate.HELD, detail=Message("no link[2J")),
)


def lines(table: Table) -> list[str]:
    return [text_of(row.runs).rstrip() for row in table.rows]


def shown(*rows: RoutineRow) -> Table:
    return routine_table(rows, "/site\x1b/routines", lambda wall: f"{wall:.0f}")


def test_without_a_routine_it_tells_where_to_write_one() -> None:
    found = lines(shown())
    assert found[0].startswith("No routine in /site") and "\x1b" not in "".join(found)
    assert "fleet-tui docs routines" in found[-1]


def test_a_run_has_a_row_for_each_robot() -> None:
    table = shown(RoutineRow("day", ("weekday 06:30",), PLANS, RUNS, 7.0, Message("ana (process 3)")))
    day, one, other = lines(table)
    assert day.split(maxsplit=4) == ["day", "△", "held", "7", "run by ana (process 3); every weekday 06:30"]
    assert one.split(maxsplit=4) == ["robot_0", "●", "running", "0", "line 2: go Base"]
    assert other.split()[:3] == ["robot_1", "△", "held"] and "no link" in other and "\x1b" not in other
    assert [row.key for row in table.rows] == ["day", ("day", "robot_0"), ("day", "robot_1")]


def test_what_is_over_or_never_ran_has_one_row() -> None:
    over = tuple(Lane(name, phase=LanePhase.DONE) for name in PLANS)
    rows = lines(
        shown(RoutineRow("day", (), PLANS, over, 7.0), RoutineRow("new", problem=Message("line 1: no lane")))
    )
    assert [row.split()[1:4] for row in rows] == [["○", "done", "7"], ["○", "never", "run"]]
    assert rows[1].endswith("line 1: no lane")


def test_a_run_that_was_left_is_held() -> None:
    day, one, _ = lines(shown(RoutineRow("day", (), PLANS, RUNS, 7.0)))
    assert "held" in day and "held" in one


def test_a_text_has_its_title() -> None:
    table = text_table(Message("day: problems"), ["line 1: \x07"])
    assert text_of(table.title).endswith("Esc: back") and "\x1b" not in text_of(table.title)
    assert "\x07" not in lines(table)[0]
