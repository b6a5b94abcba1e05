"""Columns: declared once, and head, width, order and filter follow."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import Column, FittedColumns
from fleet_tui.ui.view.tables.listing import Listing
from fleet_tui.ui.view.tables.table import Row, Table
from tests.support.fleets import text_of
from tests.support.hostile_text import TEXTS, harmless

Item = tuple[str, int, str]
COLUMNS: tuple[Column[Item], ...] = (
    Column(
        "name",
        lambda item: (item[0], StyleRole.TEXT),
        (4, 12),
        "Name",
        order=lambda item: item[0],
        stays=True,
    ),
    Column("count", lambda item: (str(item[1]), StyleRole.DIM), 5, "Count", 40, is_right=True, is_apart=True),
    Column("note", lambda item: [(item[2], StyleRole.TEXT), ("!", StyleRole.WARN)], None, "Note"),
    Column("kind", text=lambda item: "odd" if item[1] % 2 else "even"),
)
ITEMS: list[Item] = [("robot_2", 7, "waits at the lift"), ("robot_1", 12, "drives")]


def table(width: int = 60, arrangement: RowArrangement | None = None) -> Table:
    return table_of((), COLUMNS, ITEMS, lambda item: item[0], width, arrangement=arrangement, empty="none")


def lines(of: Table) -> list[str]:
    return [text_of(of.head), *(text_of(row.runs) for row in of.rows)]


def test_a_head_is_above_its_column_and_figures_end_below_each_other() -> None:
    assert lines(table()) == [
        "Name    Count Note",
        "robot_2     7 waits at the lift!",
        "robot_1    12 drives!",
    ]


def test_a_narrow_pane_has_fewer_columns_and_an_identity_gives_way_only_where_no_cell_is_free() -> None:
    assert lines(table(39))[1] == "robot_2 waits at the lift!"
    assert lines(table(17))[1] == "robot… waits at the lift!"


def test_what_takes_the_rest_between_two_others_is_cut_after_a_word() -> None:
    columns = (*COLUMNS[:1], COLUMNS[2], COLUMNS[1])
    assert text_of(FittedColumns(columns, ITEMS, 30).runs(ITEMS[0])) == "robot_2 waits at the lift!"
    fitted = FittedColumns(columns, ITEMS, 40)
    assert text_of(fitted.head) == "Name    Note                      Count "
    assert text_of(fitted.runs(ITEMS[0])) == "robot_2 waits at the lift!            7 "


def test_a_column_that_is_only_found_filters_and_sorts_by_its_name() -> None:
    chosen = RowArrangement()
    chosen.typed = "kind:odd"
    assert [row.key for row in table(60, chosen).rows] == ["robot_2"]
    chosen.typed = "7"
    assert table(60, chosen).empty.startswith("nothing matches"), "a figure is found by its name alone"
    chosen.typed = ""
    chosen.next_column()
    assert [row.key for row in table(60, chosen).rows] == ["robot_1", "robot_2"]


def test_of_many_rows_those_in_view_are_made() -> None:
    made = []

    def cell(item: int) -> tuple[str, StyleRole]:
        made.append(item)
        return str(item), StyleRole.TEXT

    many = table_of((), [Column("n", cell, 6)], range(10_000), lambda item: item, 60)
    listing = Listing()
    listing.show(many)
    listing.lines(60, 20, True)
    assert len(made) <= 20


def test_rows_below_an_opened_one_are_between_it_and_the_next() -> None:
    below = Row("below", (("its values", StyleRole.DIM),))
    opened = table_of((), COLUMNS, ITEMS, lambda item: item[0], below=lambda item: [below] * (item[1] == 7))
    assert [row.key for row in opened.rows] == ["robot_2", "below", "robot_1"]


def test_an_identity_stays_while_the_rest_of_a_row_slides() -> None:
    listing = Listing()
    listing.show(table(60))
    listing.slide(1)
    assert [text_of(line).rstrip() for line in listing.lines(21, 4, True)][2:] == [
        "▸robot_2 its at the…",
        " robot_1   12 drives!",
    ]


@given(st.lists(st.tuples(TEXTS, st.integers(), TEXTS), max_size=5), st.integers(0, 80))
def test_every_cell_is_harmless_and_none_takes_those_of_another(items: list[Item], width: int) -> None:
    fitted = FittedColumns(COLUMNS, items, width)
    starts = set()
    for item in items:
        runs = fitted.runs(item)
        assert harmless(text_of(runs))
        starts.add(cell_width(text_of(runs[: -len(COLUMNS[2].runs(item))])))
    assert all(start <= fitted.stays + 6 for start in starts)


@pytest.mark.parametrize("width", range(1, 60, 7))
def test_no_width_is_too_small(width: int) -> None:
    listing = Listing()
    listing.show(table(width))
    assert all(cell_width(text_of(line)) == width for line in listing.lines(width, 5, False))


def test_a_row_that_goes_on_below_keeps_its_columns() -> None:
    listing = Listing()
    items: list[Item] = [("r_2", 7, "waits at the lift"), ("robot_1", 12, "drives")]
    listing.show(table_of((), COLUMNS, items, lambda item: item[0], 22))
    assert [text_of(line).rstrip() for line in listing.lines(23, 4, True)][2] == "▸r_2 waits at the lift!"
    assert [text_of(line).rstrip() for line in listing.lines(23, 6, True)][1:] == [
        " Name    Note",
        "▸r_2     waits at the",
        "         lift!",
        " robot_1 drives!",
        "",
    ]
