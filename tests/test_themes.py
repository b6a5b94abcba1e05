"""Shipped themes are whole and readable; a broken one is named and leaves the rest alone."""

from pathlib import Path

import pytest
from textual.color import Color
from textual.theme import Theme

from fleet_tui.themes import load_themes, shipped_folder
from fleet_tui.view.roles import StyleRole

SHIPPED = ("colourblind", "contrast", "dark", "light")

QUIET = {
    StyleRole.FLOOR,
    StyleRole.UNKNOWN,
    StyleRole.RULE,
    StyleRole.EDGE,
    StyleRole.TRAIL,
    StyleRole.TRAIL_OLD,
}


def test_the_shipped_themes_are_there_and_fault_free() -> None:
    themes, problems = load_themes()
    assert (sorted(themes), problems) == (list(SHIPPED), [])


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_theme_names_every_ink_itself_and_makes_a_textual_theme(name: str) -> None:
    theme = load_themes()[0][name]
    text = (shipped_folder() / f"{name}.toml").read_text(encoding="utf-8")
    assert not [ink.name for ink in StyleRole if f"\n{ink.name.lower()} = " not in text]
    assert Theme(**theme.textual()).dark == (name != "light")


@pytest.mark.parametrize("name", SHIPPED)
@pytest.mark.parametrize("ink", [ink for ink in StyleRole if ink not in QUIET])
def test_what_must_be_read_stands_out(name: str, ink: StyleRole) -> None:
    style = load_themes()[0][name].styles()[ink]
    assert style.color
    assert style.bgcolor
    assert _contrast(Color.from_rich_color(style.color), Color.from_rich_color(style.bgcolor)) >= (
        2.4 if ink in (StyleRole.VERTEX, StyleRole.MISSION_NEXT) else 4.0
    )


def _contrast(one: Color, other: Color) -> float:
    """The contrast ratio of WCAG 2, from 1 to 21."""
    light = sorted(_luminance(colour) for colour in (one, other))
    return (light[1] + 0.05) / (light[0] + 0.05)


def _luminance(colour: Color) -> float:
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4
        for part in (colour.r / 255, colour.g / 255, colour.b / 255)
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


@pytest.mark.parametrize("name", SHIPPED)
def test_without_colour_the_selected_robot_still_stands_out(name: str) -> None:
    styles = load_themes()[0][name].styles(colour=False)
    assert all(style.color is None and style.bgcolor is None for style in styles.values())
    assert styles[StyleRole.ROBOT_SELECTED].reverse
    assert not styles[StyleRole.ROBOT].reverse
    assert styles[StyleRole.EDGE].dim and not styles[StyleRole.WALL].dim
    assert styles[StyleRole.MISSION].bold and styles[StyleRole.MISSION_NEXT].dim


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("nonsense", "unreadable"),
        ("[inks]\nwal = '#112233'", "inks.wal is unknown, did you mean wall?"),
        ("[inks]\nwall = 'red'", "inks.wall = 'red' is not a colour"),
        ("[inks]\nwall = { on = 3 }", "inks.wall.on = 3 is not a colour"),
        ("[inks]\nwall = { bold = 'yes' }", "inks.wall.bold must be true or false"),
        ("[inks]\nwall = { blink = true }", "inks.wall.blink is unknown"),
        ("dark = 1", "dark must be true or false"),
        ("inks = 3", "inks must be a table"),
        ("[base]\nbackground = { on = '#112233' }", "base.background"),
    ],
)
def test_a_broken_theme_is_named_and_the_rest_work(tmp_path: Path, content: str, problem: str) -> None:
    (tmp_path / "mine.toml").write_text(content)
    (tmp_path / "good.toml").write_text("dark = false\n[inks]\nwall = '#112233'")
    themes, problems = load_themes(tmp_path)
    assert len(problems) == 1
    assert "mine.toml" in problems[0]
    assert problem in problems[0]
    assert set(themes) == {*SHIPPED, "good"}
    assert themes["good"].inks[StyleRole.WALL].color == "#112233"
    assert themes["good"].inks[StyleRole.ROBOT] == themes["light"].inks[StyleRole.ROBOT]


def test_no_folder_of_ones_own_is_no_problem(tmp_path: Path) -> None:
    assert load_themes(tmp_path / "none")[1] == []
