"""A row of cells as a strip of segments."""

from rich.style import Style

from fleet_tui.ui.terminal.cell_strip import CellStrip
from fleet_tui.ui.terminal.screen_buffer import ScreenBuffer
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.roles import StyleRole


def test_a_row_of_cells_is_a_strip_to_whoever_cuts_it() -> None:
    cells = Cells.blank(6, 1, StyleRole.FLOOR)
    cells.write(1, 0, "漢ab", StyleRole.TEXT)
    strip = CellStrip(cells, 0, [Style()] * len(StyleRole))
    assert strip.divide([6]) == [strip]
    assert [part.text for part in strip.divide([2, 6])] == ["  ", " ab "]
    assert (strip.crop(0, 6), strip.crop(3, 5).text, strip.cell_length) == (strip, "ab", 6)
    assert not hasattr(strip, "something else")


def test_a_row_of_cells_changes_its_looks_with_the_theme() -> None:
    cells, pane = Cells.blank(2, 1, StyleRole.FLOOR), ScreenBuffer(None)
    pane.fit(2, 1)
    for styles, sent in (([Style()], "\x1b[1;1H  "), ([Style(bold=True)], "\x1b[1;1H\x1b[1m  \x1b[m")):
        pane.put(0, 0, 2, CellStrip(cells, 0, styles))
        assert pane.take() == sent
