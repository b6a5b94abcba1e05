"""Shipped themes are whole and readable; a broken one is named and leaves the rest alone."""

from pathlib import Path

import pytest
from textual.color import Color
from textual.theme import Theme

from fleet_tui.ui.themes import load_themes, shipped_folder
from fleet_tui.ui.view.roles import StyleRole

IN_ROWS = [getattr(StyleRole, name) for name in ("TEXT", "DIM", "ACCENT", "GOOD", "WARN", "ALARM", "KEY")]
SHIPPED = ("colourblind", "contrast", "dark", "light")

READ = (
    StyleRole.LABEL,
    StyleRole.TARGET,
    StyleRole.VERTEX_LABELLED,
    *(
        role
        for role in StyleRole
        if role >= StyleRole.TEXT and role not in (StyleRole.RULE, StyleRole.CURSOR_ROW)
    ),
)
ROBOTS = (
    StyleRole.ROBOT,
    StyleRole.CARGO,
    StyleRole.ROBOT_SELECTED,
    StyleRole.ROBOT_OFFLINE,
    StyleRole.ROBOT_WARN,
    StyleRole.ROBOT_ALARM,
)
GROUND = (StyleRole.FLOOR, StyleRole.UNKNOWN)


def test_the_shipped_themes_are_there_and_fault_free() -> None:
    themes, problems = load_themes()
    assert (sorted(themes), problems) == (list(SHIPPED), [])


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_theme_names_every_role_itself_and_makes_a_textual_theme(name: str) -> None:
    theme = load_themes()[0][name]
    text = (shipped_folder() / f"{name}.toml").read_text(encoding="utf-8")
    assert not [role.name for role in StyleRole if f"\n{role.name.lower()} = " not in text]
    assert Theme(**theme.textual()).dark == (name != "light")


class Look:
    """The colours of a theme, as WCAG 2 measures them."""

    def __init__(self, name: str) -> None:
        self.styles = load_themes()[0][name].styles()

    def colours(self, role: StyleRole) -> tuple[Color, Color]:
        """Return the colour of a role and that behind it."""
        style = self.styles[role]
        assert style.color
        assert style.bgcolor
        pair = Color.from_rich_color(style.color), Color.from_rich_color(style.bgcolor)
        return (pair[1], pair[0]) if style.reverse else pair

    def stands_out(self, role: StyleRole, ground: Color) -> float:
        """Return the contrast of a role to a ground: of its chip, or of its letters if it has none."""
        letters, behind = self.colours(role)
        return _contrast(behind if self.has_chip(role) else letters, ground)

    def has_chip(self, role: StyleRole) -> bool:
        return self.colours(role)[1] not in [self.colours(ground)[1] for ground in GROUND]

    @property
    def grounds(self) -> list[Color]:
        """Return floor, unknown ground and wall."""
        return [*(self.colours(ground)[1] for ground in GROUND), self.colours(StyleRole.WALL)[0]]


@pytest.mark.parametrize("name", SHIPPED)
@pytest.mark.parametrize("role", [*READ, *ROBOTS])
def test_text_is_readable(name: str, role: StyleRole) -> None:
    assert _contrast(*Look(name).colours(role)) >= 4.5


@pytest.mark.parametrize("name", SHIPPED)
@pytest.mark.parametrize("role", IN_ROWS)
def test_text_is_readable_in_the_row_of_the_cursor_too(name: str, role: StyleRole) -> None:
    look = Look(name)
    ground = look.styles[StyleRole.CURSOR_ROW].bgcolor
    assert ground is not None
    row = Color.from_rich_color(ground)
    assert _contrast(look.colours(role)[0], row) >= 4.5 and row != look.colours(role)[1]


@pytest.mark.parametrize("name", SHIPPED)
@pytest.mark.parametrize("role", [*ROBOTS, StyleRole.MISSION, StyleRole.TARGET])
def test_robots_and_missions_stand_out_from_floor_and_wall(name: str, role: StyleRole) -> None:
    look = Look(name)
    assert min(look.stands_out(role, ground) for ground in look.grounds) >= 3.0


@pytest.mark.parametrize("name", SHIPPED)
def test_robots_outshine_the_mission_then_labels_then_walls_then_edges(name: str) -> None:
    look = Look(name)
    floor = look.colours(StyleRole.FLOOR)[1]
    ranks = (StyleRole.ROBOT, StyleRole.MISSION, StyleRole.LABEL, StyleRole.VERTEX, StyleRole.EDGE)
    brightness = [look.stands_out(role, floor) for role in ranks]
    assert brightness == sorted(brightness, reverse=True)
    wall = look.stands_out(StyleRole.WALL, floor)
    assert 1.8 <= wall < look.stands_out(StyleRole.LABEL, floor) / 1.5


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
    assert themes["good"].roles[StyleRole.WALL].color == "#112233"
    solid = themes["good"].roles[StyleRole.WALL_SOLID]
    assert (solid.color, solid.on) == ("#112233", "#112233")
    assert themes["good"].roles[StyleRole.ROBOT] == themes["light"].roles[StyleRole.ROBOT]


def test_no_folder_of_ones_own_is_no_problem(tmp_path: Path) -> None:
    assert load_themes(tmp_path / "none")[1] == []
