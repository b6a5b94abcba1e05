"""Looks of cells: as near as a terminal can, and no colour lost in its background."""

import pytest
from rich.color import ColorSystem
from rich.color_triplet import ColorTriplet
from rich.style import Style

from fleet_tui.ui.terminal.sgr import PLAIN, Sgr, look_of, nearest, sixteen, turn
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.roles import StyleRole


def test_turns_are_as_short_as_can_be() -> None:
    bold_red, red = Sgr("1", "31", "40"), Sgr("", "31", "40")
    assert turn(PLAIN, bold_red) == "\x1b[1;31;40m"
    assert turn(red, bold_red) == "\x1b[1m"
    assert turn(bold_red, red) == "\x1b[0;31;40m"
    assert turn(red, Sgr("", "31", "")) == "\x1b[49m"
    assert turn(red, red) == ""


def test_without_colours_only_weight_is_left() -> None:
    assert look_of(Style.parse("bold reverse underline #ff0000 on #00ff00"), None) == Sgr("1;4;7")


def test_dark_grounds_stay_apart_in_256_colours() -> None:
    unknown, floor, robot = (
        nearest(ColorTriplet(*triple)) for triple in [(14, 17, 22), (27, 33, 41), (61, 74, 90)]
    )
    assert 232 <= unknown < floor < robot <= 255
    assert nearest(ColorTriplet(255, 255, 255)) == 231
    assert nearest(ColorTriplet(0, 95, 175)) == 25


def test_a_bluish_grey_is_grey_in_256_colours_too() -> None:
    label, vertex = (nearest(ColorTriplet(*triple)) for triple in [(141, 157, 173), (168, 188, 205)])
    assert 232 <= label < vertex <= 255


@pytest.mark.parametrize(
    ("triple", "number"),
    [
        ((197, 51, 43), 1),
        ((255, 106, 95), 9),
        ((232, 184, 74), 11),
        ((90, 200, 250), 14),
        ((61, 127, 158), 6),
        ((0, 0, 0), 0),
        ((93, 114, 134), 8),
        ((152, 164, 179), 7),
        ((255, 255, 255), 15),
    ],
)
def test_with_16_colours_a_hue_stays_that_hue(triple: tuple[int, int, int], number: int) -> None:
    assert sixteen(ColorTriplet(*triple)) == number


@pytest.mark.parametrize("colours", [ColorSystem.STANDARD, ColorSystem.EIGHT_BIT, ColorSystem.TRUECOLOR])
@pytest.mark.parametrize("name", ["colourblind", "contrast", "dark", "light"])
def test_no_role_vanishes_in_its_ground_however_few_colours_there_are(
    name: str, colours: ColorSystem
) -> None:
    styles = load_themes()[0][name].styles()
    row = Style(bgcolor=styles.pop(StyleRole.CURSOR_ROW).bgcolor)
    looks = {role: look_of(style, colours) for role, style in styles.items()}
    in_row = {role: look_of(style + row, colours) for role, style in styles.items() if role >= StyleRole.TEXT}
    assert [role for role, look in in_row.items() if _as_ground(look.color) == look.on] == []
    # A full block is its own ground.
    assert [role for role, look in looks.items() if _as_ground(look.color) == look.on] == [
        StyleRole.WALL_SOLID
    ]
    assert looks[StyleRole.ROBOT].on != looks[StyleRole.FLOOR].on
    assert looks[StyleRole.ROBOT_SELECTED] != looks[StyleRole.ROBOT]
    if colours is not ColorSystem.STANDARD and name != "contrast":
        assert looks[StyleRole.FLOOR].on != looks[StyleRole.UNKNOWN].on


def _as_ground(color: str) -> str:
    first, *rest = color.split(";")
    return ";".join([str(int(first) + 10), *rest])
