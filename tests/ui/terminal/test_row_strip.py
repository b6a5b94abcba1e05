"""A row that was painted is free as soon as nobody holds it: no search for garbage is needed."""

import gc
from collections.abc import Callable

import numpy as np
import pytest
from rich.segment import Segment
from rich.style import Style
from textual.strip import Strip

from fleet_tui.ui.terminal.cell_strip import CellStrip
from fleet_tui.ui.terminal.row_strip import RowStrip
from fleet_tui.ui.view.map.cells import Cells


def of_segments() -> Strip:
    return RowStrip([Segment("robot_0 "), Segment("42 %")])


def of_cells() -> Strip:
    return CellStrip(Cells(np.full((1, 12), ord("x"), np.uint32), np.zeros((1, 12), np.uint8)), 0, [Style()])


@pytest.mark.parametrize("make", [of_segments, of_cells])
def test_it_leaves_no_garbage(make: Callable[[], Strip]) -> None:
    make()
    gc.disable()
    try:
        before = strips()
        strip = make()
        assert [part.text for part in strip.divide([8, 12])] == [strip.text[:8], strip.text[8:]]
        assert strip.divide([12]) == [strip]
        del strip
        assert strips() == before
    finally:
        gc.enable()


def strips() -> int:
    return sum(isinstance(one, Strip) for one in gc.get_objects())
