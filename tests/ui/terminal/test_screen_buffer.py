"""Cells, looks and the bytes between them."""

import sys
from collections.abc import Iterable
from unicodedata import normalize

import pyte
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.cells import get_character_cell_size
from rich.color import ColorSystem
from rich.segment import Segment
from rich.style import Style

from fleet_tui.ui.terminal import screen_buffer
from fleet_tui.ui.terminal.cell_strip import CellStrip
from fleet_tui.ui.terminal.screen_buffer import ONE_CELL_EACH, ScreenBuffer
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.roles import StyleRole


def glass(width: int, height: int = 1, colours: ColorSystem | None = None) -> ScreenBuffer:
    made = ScreenBuffer(colours)
    made.fit(width, height)
    return made


def put(onto: ScreenBuffer, x: int, text: str, style: str = "", y: int = 0, end: int | None = None) -> str:
    """Want a text, and what goes out for it."""
    onto.put(x, y, x + 99 if end is None else end, [Segment(text, Style.parse(style))])
    return onto.take()


def test_only_what_changed_goes_out() -> None:
    pane = glass(10, 2)
    assert put(pane, 0, "abc") == "\x1b[1;1Habc"
    assert put(pane, 0, "abc") == ""
    assert put(pane, 0, "aXc") == "\x1b[1;2HX"
    assert put(pane, 0, "a  ", y=1) == "\x1b[2;1Ha  "


def test_a_short_way_along_the_row_is_named_as_such() -> None:
    pane = glass(20)
    put(pane, 0, "." * 20)
    assert put(pane, 0, "#.#....#............") == "\x1b[1;1H#\x1b[C#\x1b[4C#"


def test_after_the_last_column_the_next_place_is_named_outright() -> None:
    pane = glass(3, 2)
    put(pane, 0, "...", y=0)
    put(pane, 0, "...", y=1)
    pane.put(2, 0, 3, [Segment("#")])
    pane.put(1, 1, 2, [Segment("#")])
    assert pane.take() == "\x1b[1;3H#\x1b[2;2H#"


def test_looks_are_grouped_and_left_plain() -> None:
    pane = glass(6, colours=ColorSystem.TRUECOLOR)
    red, blue = Style.parse("#ff0000"), Style.parse("#0000ff bold")
    pane.put(0, 0, 6, [Segment("a", red), Segment("b", blue), Segment("c", red)])
    assert pane.take() == "\x1b[1;1H\x1b[38;2;255;0;0ma\x1b[Cc\x1b[1;2H\x1b[1;38;2;0;0;255mb\x1b[m"


def test_forgotten_cells_go_out_again_and_cells_never_wanted_do_not() -> None:
    pane = glass(4)
    put(pane, 1, "ab")
    pane.forget()
    assert pane.take() == "\x1b[1;2Hab"


@pytest.mark.parametrize(
    "texts",
    [
        ["漢字ab", "x漢字b", "漢字ab"],
        ["漢字ab", "漢xyab", "xy字ab", "abcdef"],
        ["e\u0301a\u0308bcde", "e\u0301xbcde", "yxbcde"],
        ["→漢●1ab", "漢→1●ab"],
    ],
)
def test_wide_and_combined_characters_come_and_go_whole(texts: Iterable[str]) -> None:
    pane, screen = glass(8), pyte.Screen(8, 1)
    stream = pyte.Stream(screen)
    for text in texts:
        stream.feed(put(pane, 0, text))
        other = pyte.Screen(8, 1)
        pyte.Stream(other).feed(text)
        assert screen.display == other.display


def test_after_what_may_be_wider_on_a_terminal_the_next_place_is_named_outright() -> None:
    pane = glass(6)
    put(pane, 0, "......")
    assert put(pane, 0, "e\u0301.x...") == "\x1b[1;1He\u0301\x1b[1;3Hx"
    assert put(pane, 0, "漢y...") == "\x1b[1;1H漢\x1b[1;3Hy"


def test_what_lies_over_half_a_wide_character_takes_the_other_half_too() -> None:
    pane = glass(6)
    put(pane, 0, "a漢bcd")
    assert put(pane, 2, "|", end=3) == "\x1b[1;2H |"
    assert put(pane, 0, "a漢bcd") == "\x1b[1;2H漢"


def test_control_characters_stay_here() -> None:
    assert put(glass(4), 0, "a\x1b\x07b\x9b") == "\x1b[1;1Hab"


def test_what_is_taken_for_one_cell_takes_one_cell() -> None:
    characters = [chr(code) for code in range(sys.maxunicode + 1)]
    taken = [character for character in characters if ONE_CELL_EACH.fullmatch(character)]
    assert [character for character in taken if get_character_cell_size(character) != 1] == []


STYLES = [Style.parse(f"color({role.value})") for role in StyleRole]
texts_at = st.tuples(st.integers(-2, 12), st.text("ab→漢●", max_size=5), st.sampled_from(StyleRole))


@given(st.lists(texts_at, max_size=6), st.integers(0, 3), st.integers(5, 14))
def test_a_row_of_cells_is_put_as_its_segments_would_be(
    texts: list[tuple[int, str, StyleRole]], x: int, end: int
) -> None:
    cells = Cells.blank(12, 1, StyleRole.FLOOR)
    for at, text, role in texts:
        cells.write(at, 0, text, role)
    strip = CellStrip(cells, 0, STYLES)
    for one, other in ((strip, list(strip)), (list(strip), strip)):
        pane = glass(16, colours=ColorSystem.TRUECOLOR)
        put(pane, 0, "漢" * 8)
        pane.put(x, 0, end, one)
        assert pane.take()
        pane.put(x, 0, end, other)
        assert pane.take() == ""


def test_full_blocks_of_a_picture_have_their_own_colour_as_ground() -> None:
    cells = Cells.blank(3, 1, StyleRole.FLOOR)
    cells.write(0, 0, "█▀", StyleRole.WALL)
    styles = [Style.parse("color(7) on color(4)")] * len(StyleRole)
    screen = pyte.Screen(3, 1)
    pane = glass(3, colours=ColorSystem.STANDARD)
    pane.put(0, 0, 3, CellStrip(cells, 0, styles))
    pyte.Stream(screen).feed(pane.take())
    shown = [(screen.buffer[0][x].data, screen.buffer[0][x].fg, screen.buffer[0][x].bg) for x in range(2)]
    assert shown == [("█", "white", "white"), ("▀", "white", "blue")]


def test_looks_and_odd_characters_that_are_out_of_view_are_forgotten(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(screen_buffer, "REMEMBERED", 1024)
    onto, terminal = glass(8, 2, ColorSystem.TRUECOLOR), pyte.Screen(8, 2)
    stream = pyte.Stream(terminal)
    marks = [chr(code) for code in range(0x300, 0x340)]
    for n in range(3_000):
        cluster = f"{chr(ord('a') + n % 26)}{marks[n // 26 % 64]}{marks[n // 1664]}"
        style = Style(color=f"#{n % 256:02x}{n // 256:02x}80")
        onto.put(0, n % 2, 8, [Segment(f"{n:06d}", style), Segment(cluster, Style(bold=True)), Segment(" ")])
        stream.feed(onto.take())
        assert max(len(onto.looks), len(onto.clusters)) <= 1024 + 2 * 16
    assert [line[:6] for line in terminal.display] == ["002998", "002999"]
    assert terminal.buffer[1][6].data == normalize("NFC", cluster)
    assert (terminal.buffer[0][0].fg, terminal.buffer[1][0].fg) == ("b60b80", "b70b80")
    assert onto.take() == ""
