"""The screens before the console: all they say stands in the rows there are."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.ui.view.tables.opening import Asked, Line, arrival_rows, first_run_rows, footer
from fleet_tui.ui.view.tables.table import width_of
from tests.support.fleets import text_of
from tests.support.hostile_text import TEXTS, harmless

PLACES = [("FLEET_TUI_CONFIG", "not set"), ("./config.toml", "not there")]


def test_it_says_where_it_looked_and_what_is_at_an_address() -> None:
    asked = Asked("ws://robot:9090", "2 robots", ("robot_0", "robot_1"), is_found=True)
    text = "\n".join(text_of(row) for row in first_run_rows(PLACES, asked, 80, 24))
    for words in (
        "FLEET_TUI_CONFIG",
        "not there",
        "ws://robot:9090",
        "2 robots",
        "robot_1",
        "fleet-tui demo",
    ):
        assert words in text


def test_each_choice_says_what_holds_now() -> None:
    lines = [Line("kind of robot_0", "nav2", 1, 2), Line("pose of nav2", "", 0, 3)]
    rows = [text_of(row) for row in arrival_rows("1 robot", lines, ["no map"], 1, 80, 24)]
    assert any("kind of robot_0" in row and "< nav2" in row and "1 of 2" in row for row in rows)
    assert any(row.startswith(" > pose of nav2") and "none of 3" in row for row in rows)
    assert any("no map" in row for row in rows)


def test_the_choice_under_the_cursor_is_in_view_however_many_there_are() -> None:
    lines = [Line(f"choice {n}", "x", 1, 2) for n in range(50)]
    for cursor in (0, 25, 49):
        rows = [text_of(row) for row in arrival_rows("s", lines, [], cursor, 60, 12)]
        assert any(row.startswith(f" > choice {cursor} ") for row in rows)


@given(TEXTS, st.integers(20, 120), st.integers(1, 40))
def test_there_are_as_many_rows_as_there_is_room_for(words: str, width: int, height: int) -> None:
    asked = Asked(words, words, (words,))
    for rows in (
        first_run_rows([(words, "not there")], asked, width, height),
        arrival_rows(words, [Line(words, words, 1, 2)], [words], 0, width, height),
    ):
        assert len(rows) == height
        assert all(width_of(row) == width and all(harmless(text) for text, _ in row) for row in rows)


def test_the_footer_names_keys_and_what_they_do() -> None:
    assert text_of(footer([("Enter", "open"), ("q", "leave")])) == " Enter open  q leave "
