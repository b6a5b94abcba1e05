"""Columns of the fleet pane: fixed by the width, and by what robots report."""

import pytest
from msgspec.structs import replace

from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.short_names import own_names, shortened
from tests.support.fleets import R0, T0, battery, fleet, link_up, pose, reduced, text_of


@pytest.mark.parametrize(
    ("floors", "shown"),
    [
        ({"floor_0", "floor_1"}, {"floor_0": "0", "floor_1": "1"}),
        ({"floor_1", "floor_10", "-"}, {"floor_1": "1", "floor_10": "10", "-": "-"}),
        ({"east", "west"}, {"east": "east", "west": "west"}),
        ({"hall_0"}, {"hall_0": "hall_0"}),
        ({"a_", "a_b"}, {"a_": "a_", "a_b": "b"}),
        ({"floor_0", "floor_1", "unknown floor"}, {"floor_0": "0", "floor_1": "1", "unknown floor": "?"}),
        (set(), {}),
    ],
)
def test_floors_lose_the_beginning_that_all_have(floors: set[str], shown: dict[str, str]) -> None:
    assert shortened(floors) == shown


@pytest.mark.parametrize("width", [30, 47, 60, 79, 120])
def test_heads_begin_where_their_columns_do(width: int) -> None:
    state = reduced(fleet(1, 2), link_up(T0), pose(T0), battery(T0))
    table = fleet_table(state, R0, width)
    head, row = text_of(table.head), text_of(table.rows[0].runs)
    assert head.index("Robot") == row.index("robot_0")
    assert head.index("Batt") - 1 == row.index(" 80 %") or head.index("Batt") == row.index(" 80 %")
    assert row.startswith("floor_0" if width >= 54 else "0 ", head.index("Fl"))
    assert ("Floor" in head) == (width >= 54)
    assert (" Order " in head) == (width >= 79) and "State" in head


def test_the_last_head_is_whole_or_shorter() -> None:
    state = reduced(fleet(), link_up(T0), pose(T0), battery(T0))
    least = 40 - len(text_of(fleet_table(state, R0, 40).head).removesuffix("State, order"))
    for spare, head in ((12, "State, order"), (11, "State")):
        shown = text_of(fleet_table(state, R0, 40 - least + spare).head)
        assert shown.endswith(f" {head}")


def test_floors_keep_their_short_names_when_all_robots_are_on_one() -> None:
    state = reduced(fleet(2, 2), link_up(T0), pose(T0))
    assert " 0 " in text_of(fleet_table(state, R0, 47).rows[0].runs)


def test_a_row_without_an_order_ends_with_its_state() -> None:
    state = reduced(fleet(), link_up(T0))
    for width in range(30, 54):
        shown = text_of(fleet_table(state, R0, width).rows[0].runs)
        assert shown.rstrip().endswith("never seen") and len(shown) - len(shown.rstrip()) <= 1


@pytest.mark.parametrize("width", [30, 47, 60, 120])
def test_the_first_column_has_the_numbers_that_are_keys_and_marks_of_the_map(width: int) -> None:
    table = fleet_table(fleet(3), R0, width)
    assert text_of(table.head).startswith("  # Robot")
    assert [text_of(row.runs)[2:11] for row in table.rows] == ["0 robot_0", "1 robot_1", "2 robot_2"]


def test_in_a_narrow_pane_a_robot_of_a_fleet_has_its_own_name_if_that_is_unique() -> None:
    assert own_names(("tiny/robot_0", "carrier/robot_1", "robot_2")) == {
        "tiny/robot_0": "robot_0",
        "carrier/robot_1": "robot_1",
        "robot_2": "robot_2",
    }
    assert own_names(("fleet/", "robot_2"))["fleet/"] == "fleet/"
    assert own_names(("tiny/robot_0", "carrier/robot_0"))["tiny/robot_0"] == "tiny/robot_0"
    state = fleet(2)
    names = dict(zip(("tiny/robot_0", "carrier/robot_1"), state.robots.values(), strict=True))
    robots = {name: replace(robot, name=name) for name, robot in names.items()}
    state = replace(state, robots=robots)
    rows = [text_of(row.runs) for row in fleet_table(state, "tiny/robot_0", 40).rows]
    assert "robot_0 " in rows[0] and "tiny" not in "".join(rows)
    assert "tiny/robot_0 " in text_of(fleet_table(state, "tiny/robot_0", 100).rows[0].runs)
