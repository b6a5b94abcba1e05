"""Walls of the picture are as thick as they are, and thin ones have no gaps."""

import numpy as np
import pytest

from fleet_tui.ui.view.map.ground.walls import wall_blocks


def blocks(*rows: str) -> list[str]:
    """Return the blocks of a drawing of their parts."""
    parts = np.array([[letter == "#" for letter in row] for row in rows])
    return ["".join(" #"[one] for one in row) for row in wall_blocks(parts).tolist()]


WALL_WITH_ONE_BELOW = (
    ["............", "############", "############", "......#.....", "......#.....", "......#....."],
    ["######", "   #  ", "   #  "],
)
THICK_WALL_IN_A_CORNER = (
    ["############", "############", "############", "###.........", "###.........", "###........."],
    ["######", "#     ", "#     "],
)


@pytest.mark.parametrize("case", [WALL_WITH_ONE_BELOW, THICK_WALL_IN_A_CORNER])
def test_a_wall_is_a_straight_line_of_its_own_thickness(case: tuple[list[str], list[str]]) -> None:
    parts, expected = case
    assert blocks(*parts) == expected
    turned = ["".join(column) for column in zip(*parts, strict=True)]
    assert blocks(*turned) == ["".join(column) for column in zip(*expected, strict=True)]
