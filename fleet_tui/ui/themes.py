"""Colour themes: one TOML file each, shipped ones first, then the user's own."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from msgspec import Struct, structs
from rich.style import Style

from fleet_tui.config.small_file import read_toml
from fleet_tui.text.errors import ConfigError, did_you_mean
from fleet_tui.ui.view.roles import StyleRole

_COLOUR = re.compile(r"#[0-9a-fA-F]{6}\Z")
_ATTRIBUTES = ("bold", "reverse", "underline", "dim")
QUIET = {
    StyleRole.FLOOR,
    StyleRole.UNKNOWN,
    StyleRole.EDGE,
    StyleRole.TRAIL,
    StyleRole.TRAIL_OLD,
    StyleRole.MISSION_NEXT,
    StyleRole.RULE,
}
BASE = ("background", "surface", "foreground", "accent")


class RoleStyle(Struct, frozen=True):
    """The look of one style role: colours as `#rrggbb` or None for the terminal's own."""

    color: str | None = None
    on: str | None = None
    bold: bool = False
    reverse: bool = False
    underline: bool = False
    dim: bool = False


class FleetTheme(Struct, frozen=True):
    """A name, the screen's base colours, and a style per role."""

    name: str
    dark: bool
    base: Mapping[str, str]
    roles: Mapping[StyleRole, RoleStyle]

    def styles(self, colour: bool = True) -> dict[StyleRole, Style]:
        """Return every role as a Rich style; without colour (NO_COLOR) only bold, reverse, underline, dim
        stay.

        Roles that colours would keep in the background are dim then, so that an edge is no wall.
        """
        return {
            role: _style(role, look, self.base["background"], colour) for role, look in self.roles.items()
        }

    def textual(self) -> dict[str, Any]:
        """Return the arguments of a `textual.theme.Theme`."""
        colours = {name: self.roles[role].color for name, role in _TEXTUAL.items()}
        base = {name: self.base[name] for name in BASE}
        return {
            "name": f"fleet-{self.name}",
            "primary": self.base["accent"],
            "panel": self.base["surface"],
            "dark": self.dark,
            **base,
            **colours,
        }


_TEXTUAL = {
    "secondary": StyleRole.DIM,
    "warning": StyleRole.WARN,
    "error": StyleRole.ALARM,
    "success": StyleRole.GOOD,
}


def _style(role: StyleRole, look: RoleStyle, background: str, colour: bool) -> Style:
    # None, not False: an explicit "off" would be one more code on the wire.
    return Style(
        color=look.color if colour else None,
        bgcolor=(look.on or background) if colour else None,
        bold=look.bold or None,
        reverse=look.reverse or None,
        underline=look.underline or None,
        dim=look.dim or (not colour and role in QUIET) or None,
    )


def shipped_folder() -> Path:
    """Return the folder of the themes shipped with the program: in a wheel inside the package, else beside
    it."""
    package = Path(__file__).parents[1]
    inside = package / "themes_shipped"
    return inside if inside.is_dir() else package.parent / "themes"


def load_themes(user_folder: Path | None = None) -> tuple[dict[str, FleetTheme], list[str]]:
    """Return all themes by name (a user's replaces a shipped one of its name), and a line per broken file.

    A user's theme may be short: missing parts are as in the shipped dark or light one.
    """
    themes: dict[str, FleetTheme] = {}
    problems: list[str] = []
    for folder in (shipped_folder(), user_folder):
        for path in sorted(folder.glob("*.toml")) if folder else ():
            try:
                theme = read_theme(path, themes)
            except ConfigError as error:
                problems += [f"{path}: {problem}" for problem in error.problems]
            else:
                themes[theme.name] = theme
    return themes, problems


def read_theme(path: Path, others: Mapping[str, FleetTheme]) -> FleetTheme:
    """Return one theme from its file; raises ConfigError with all its errors."""
    try:
        content = read_toml(path)
    except (OSError, ValueError, RecursionError) as error:
        raise ConfigError([f"unreadable: {error}"]) from error
    problems = list(_problems(content))
    dark = content.get("dark", True) is not False
    start = others.get("dark" if dark else "light")
    if not problems and start is None:
        problems = list(_gaps(content))
    if problems:
        raise ConfigError(problems)
    base, roles = (start.base, start.roles) if start else ({}, {})
    own = {StyleRole[name.upper()]: _look(value) for name, value in content.get("inks", {}).items()}
    if StyleRole.WALL in own:
        colour = own[StyleRole.WALL].color
        own.setdefault(StyleRole.WALL_SOLID, RoleStyle(color=colour, on=colour))
    return FleetTheme(path.stem, dark, {**base, **content.get("base", {})}, {**roles, **own})


def _look(value: str | dict[str, Any]) -> RoleStyle:
    return RoleStyle(color=value) if isinstance(value, str) else structs.replace(RoleStyle(), **value)


def _problems(content: dict[str, Any]) -> Iterator[str]:
    """Return every error of a theme."""
    yield from _unknown_keys("", content, ("dark", "base", "inks"))
    if not isinstance(content.get("dark", True), bool):
        yield "dark must be true or false"
    for table, names in (("base", BASE), ("inks", [role.name.lower() for role in StyleRole])):
        entries = content.get(table, {})
        if not isinstance(entries, dict):
            yield f"{table} must be a table"
            continue
        yield from _unknown_keys(f"{table}.", entries, names)
        for name, value in entries.items():
            yield from _value_problems(f"{table}.{name}", value, table == "inks")


def _value_problems(key: str, value: object, table_allowed: bool) -> Iterator[str]:
    if isinstance(value, dict) and table_allowed:
        yield from _unknown_keys(f"{key}.", value, ("color", "on", *_ATTRIBUTES))
        for name, part in value.items():
            if name in _ATTRIBUTES and not isinstance(part, bool):
                yield f"{key}.{name} must be true or false"
            elif name in ("color", "on"):
                yield from _value_problems(f"{key}.{name}", part, False)
    elif not (isinstance(value, str) and _COLOUR.match(value)):
        yield f'{key} = {value!r} is not a colour: use "#rrggbb"'


def _unknown_keys(
    prefix: str, entries: Mapping[str, object], names: list[str] | tuple[str, ...]
) -> Iterator[str]:
    for name in entries:
        if name not in names:
            yield f"{prefix}{name} is unknown{did_you_mean(name, names)}"


def _gaps(content: dict[str, Any]) -> Iterator[str]:
    """Return the missing parts of a theme without a base theme."""
    for table, names in (("base", BASE), ("inks", tuple(role.name.lower() for role in StyleRole))):
        for name in names:
            if name not in content.get(table, {}):
                yield f"{table}.{name} is missing"
