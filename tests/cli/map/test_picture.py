"""A map as text."""

import numpy as np

from fleet_tui.cli.map.picture import SIZE, map_text, output_drawing, output_size
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.occupancy import build_grid
from fleet_tui.ui.view.map.drawing import Drawing


def test_it_is_as_large_as_the_output() -> None:
    cells = np.ones((300, 100), np.uint8)
    cells[0] = cells[-1] = 2
    text = map_text(build_grid(MapFrame(0.05, 100, 300), cells), 80, 20, Drawing.ASCII)
    lines = text.split("\n")
    assert len(lines) <= 20 and max(map(len, lines)) <= 80 and "#" in lines[0]


def test_without_a_terminal_it_has_the_usual_size() -> None:
    assert output_size() == SIZE and output_drawing() in Drawing
