"""The part of a table in view: a cursor that stays with its row, scrolled and slid."""

import msgspec
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.listing import CURSOR, Listing
from fleet_tui.ui.view.tables.table import Button, Row, Run, Table, width_of
from tests.support.fleets import text_of


def table(*keys: str | None, buttons: tuple[Button, ...] = ()) -> Table:
    rows = [Row(key, ((f"row {key} " * 8, StyleRole.TEXT),), buttons) for key in keys]
    return Table((("Rows", StyleRole.TITLE),), rows, "nothing here")


def lines(listing: Listing, height: int, width: int = 20) -> list[str]:
    return [text_of(runs).rstrip() for runs in listing.lines(width, height, True)]


def test_the_cursor_stays_with_its_row_and_goes_to_the_next_where_that_is_gone() -> None:
    listing = Listing()
    listing.show(table("a", "b", "c"))
    listing.move(1)
    listing.show(table("x", "a", "b", "c"))
    assert [listing.cursor] == ["b"]
    listing.show(table("x", "a", "c"))
    assert [listing.cursor] == ["c"], "which is now in its place"
    listing.show(table())
    assert listing.cursor is None and not listing.move(1)


def test_a_cursor_at_the_end_of_a_log_stays_there_and_anywhere_else_with_its_row() -> None:
    listing = Listing()
    for rows, cursor in (("ab", "b"), ("abc", "c"), ("bcd", "d")):
        listing.show(msgspec.structs.replace(table(*rows), is_followed=True))
        assert listing.cursor == cursor
    listing.move(-1)
    listing.show(msgspec.structs.replace(table(*"bcde"), is_followed=True))
    assert listing.cursor == "c"


def test_the_cursor_never_stays_on_a_row_that_has_none() -> None:
    listing = Listing()
    listing.show(table("a", "b"))
    listing.move(1)
    listing.show(table("c", None))  # an alarm with its advice, after two without
    assert listing.cursor == "c"
    listing.show(table(None))
    assert listing.cursor is None
    listing.show(table(None, "d"))
    assert listing.cursor == "d"


def test_a_row_that_the_cursor_came_to_by_itself_is_only_proposed() -> None:
    listing = Listing()
    listing.show(table("a", "b"))
    assert listing.proposed == "a"
    listing.move(0)
    assert listing.proposed is None, "a click on the marked row chooses it"
    listing.show(table("a", "b"))
    assert listing.proposed is None, "new rows take no choice back"
    listing.show(table("b"))
    assert listing.proposed == "b"
    listing.choose("b")
    assert listing.cursor == "b" and listing.proposed is None


def test_an_empty_table_says_why() -> None:
    listing = Listing()
    listing.show(table())
    assert lines(listing, 3)[1] == " nothing here"


def test_the_title_tells_which_rows_are_in_view() -> None:
    listing = Listing()
    listing.show(table(*"abcdefgh"))
    assert lines(listing, 4, 30)[0].startswith("─ Rows  1-3 of 8 ─")
    listing.move(5)
    assert lines(listing, 4, 30)[0].startswith("─ Rows  4-6 of 8 ─")
    assert " of " not in lines(listing, 9, 30)[0]


def test_long_rows_slide_and_never_beyond_their_end() -> None:
    listing = Listing()
    listing.show(table("a"))
    listing.slide(1)
    assert lines(listing, 2)[1] == f"{CURSOR}w a row a row a…"
    listing.slide(99)
    assert lines(listing, 2)[1].endswith("row a")
    listing.slide(-200)
    assert lines(listing, 2)[1].startswith(f"{CURSOR}row a")


@given(st.integers(0, 12), st.lists(st.integers(-14, 14), max_size=6), st.integers(2, 9))
def test_the_cursors_row_is_always_in_view(count: int, steps: list[int], height: int) -> None:
    listing = Listing()
    listing.show(table(*(chr(97 + n) for n in range(count))))
    for step in steps:
        listing.move(step)
        shown = listing.lines(30, height, True)
        assert len(shown) == height and all(width_of(runs) == 30 for runs in shown)
        assert sum(text_of(runs).startswith(CURSOR) for runs in shown) == min(count, 1)


def test_a_row_is_pointed_at_by_its_line_and_a_button_by_its_cells() -> None:
    listing = Listing()
    listing.show(table("a", "b", "c", buttons=(Button(4, 8, "cancel"),)))
    listing.lines(30, 3, True)
    assert listing.shows_row(2) and not listing.shows_row(0)
    assert listing.steps_to(2) == 1
    assert (listing.button_at(5, 1), listing.button_at(9, 1)) == ("cancel", "")


def test_columns_have_heads_in_a_pane_that_has_lines_for_them() -> None:
    listing = Listing()
    few, many = (
        msgspec.structs.replace(table(*keys), head=(("Name", StyleRole.DIM),)) for keys in ("ab", "abcdef")
    )
    for shown, height, has_head in ((few, 4, True), (few, 3, False), (many, 4, False), (many, 5, True)):
        listing.show(shown)
        assert lines(listing, height)[1].endswith("Name") is has_head


def test_a_long_row_goes_on_below_while_lines_are_free_and_a_click_there_means_it() -> None:
    listing = Listing()
    listing.show(table("a", "b"))
    first, rest = " ".join(["row a"] * 5), " ".join(["row a"] * 3)
    assert lines(listing, 3, 31)[1].endswith("…")
    shown = [f"▸{first}", f"   {rest}", f" {first}".replace("a", "b"), f"   {rest}".replace("a", "b")]
    assert lines(listing, 6, 31)[1:5] == shown
    assert [listing.steps_to(y) for y in (1, 2, 3, 4)] == [0, 0, 1, 1] and not listing.shows_row(5)
    assert lines(listing, 4, 31)[1:3] == shown[:2] and lines(listing, 4, 31)[3].endswith("…")
    listing.slide(1)
    assert not any(lines(listing, 6, 31)[3:]), "one that slides needs no more lines"


def test_the_rows_in_view_are_told_beside_a_button_of_the_title() -> None:
    rows = [Row(n, ((f"row {n}", StyleRole.TEXT),)) for n in range(9)]
    title: list[Run] = [("Rows", StyleRole.TITLE), (" " * 16, StyleRole.TEXT), ("[Clear]", StyleRole.KEY)]
    listing = Listing()
    listing.show(Table(tuple(title), rows, title_buttons=(Button(20, 27, "clear"),)))
    assert lines(listing, 4, 40)[0].startswith("─ Rows  1-3 of 9      [Clear] ")
    title[1] = " " * 9, StyleRole.TEXT
    listing.show(Table(tuple(title), rows, title_buttons=(Button(13, 20, "clear"),)))
    assert lines(listing, 4, 40)[0].startswith("─ Rows         [Clear] ")
