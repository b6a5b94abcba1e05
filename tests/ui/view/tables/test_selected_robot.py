"""The selected robot's page shows each value with its age, and what was done with it."""

from msgspec import structs

from fleet_tui.model import events
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.desk.events import RobotClaimed
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.selected_robot import robot_page
from tests.support.fleets import (
    R0,
    T0,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    pose,
    queue,
    reduced,
    text_of,
    tick,
)


def page(state: FleetState) -> str:
    table = robot_page(state, R0, 80, lambda wall: "12:00:00")
    return "\n".join(text_of(runs) for runs in (table.title, *(row.runs for row in table.rows)))


def line(state: FleetState, name: str) -> str:
    return next((one for one in page(state).splitlines() if one.startswith(name)), "")


def received(*facts: events.Event) -> FleetState:
    return reduced(fleet(), link_up(T0), pose(T0), battery(T0), queue(T0), *facts, tick(T0 + 0.5))


def test_each_value_has_its_age_and_an_old_one_is_marked() -> None:
    assert "80 %" in line(received(), "Battery") and "0 s ago" in line(received(), "Battery")
    assert "not received" in line(received(), "Cargo")
    old = reduced(received(), pose(T0 + 60), tick(T0 + 60))
    (row,) = [row for row in robot_page(old, R0, 80, str).rows if "Battery" in text_of(row.runs)]
    assert StyleRole.WARN in {role for _, role in row.runs}


def test_its_alarm_and_what_to_do_are_on_it_and_the_place_by_name() -> None:
    low = reduced(received(graph(1, 2), labels({1: "Base"}), battery(T0 + 1, 5.0)), tick(T0 + 1))
    assert "battery 5 %" in line(low, "Alarm")
    assert "Send it to a charger" not in page(low), "the alarms pane explains the marked one of a few"
    many = structs.replace(low, alarms=low.alarms * 5)
    assert "Send it to a charger" in page(many)
    assert line(low, "Place").split()[1:] == ["at", "Base"]


def test_what_an_alarm_says_at_length_pushes_no_value_down() -> None:
    low = reduced(received(battery(T0 + 1, 5.0)), tick(T0 + 1))
    names = [text_of(row.runs).split()[0] for row in robot_page(low, R0, 42, str).rows]
    assert names.index("State") < names.index("Pose") < names.index("Battery") < names.index("Alarm")


def test_in_few_cells_the_floor_is_told_once_and_ages_are_in_their_column() -> None:
    state = received(graph(1, 2), labels({1: "Base"}))
    rows = [text_of(row.runs) for row in robot_page(state, R0, 42, str).rows]
    told = next(row for row in rows if row.startswith("Pose"))
    assert "floor_0" not in told and told.rstrip().endswith(" 0 s")
    assert told.index(" 0 s") == next(row for row in rows if row.startswith("Battery")).index(" 0 s")
    assert "floor_0" in line(state, "Pose") and "floor_0" in text_of(
        robot_page(received(), R0, 42, str).rows[1].runs
    ), "without a label it is nowhere else"


def test_a_jump_of_its_pose_is_told_with_its_age() -> None:
    assert line(received(), "Jumped") == ""
    jumped = received(pose(T0 + 0.2, 30.0, 40.0))
    assert "50.0 m" in line(jumped, "Jumped") and "ago" in line(jumped, "Jumped")


def test_what_it_does_and_its_news_are_the_first_line() -> None:
    assert page(received()).splitlines()[1].split() == ["State", "idle"]
    claimed = received(RobotClaimed(R0))
    assert line(claimed, "State").split()[-1] == "idle" and "claimed by" in line(claimed, "State")
    assert page(reduced(received(), tick(T0 + 30))).splitlines()[1].startswith("State     offline 30 s")


def test_the_order_and_the_commands_given_here() -> None:
    named = (graph(1, 2), labels({1: "Base", 2: "Store"}), queue(T0, (4, 1, 2, "W"), current=4))
    state = received(*named, *commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0))
    assert "Base -> Store" in line(state, "Order")
    assert "pause: accepted" in line(state, "12:00:00")


def test_it_drives_or_stands_in_the_word_of_its_row() -> None:
    order = queue(T0, (4, 1, 2, "W"), current=4)
    went = received(order, pose(T0 + 0.4, 0.3))
    assert line(went, "State").split() == ["State", "driving"] and line(went, "Movement") == ""
    stood = reduced(
        went, pose(T0 + 7.4, 0.3), battery(T0 + 7), queue(T0 + 7, (4, 1, 2, "W"), current=4), tick(T0 + 7.5)
    )
    assert line(stood, "State").split() == ["State", "waiting", "7", "s"]
    assert "waiting 7 s" in text_of(fleet_table(stood, R0, 60).rows[0].runs)
