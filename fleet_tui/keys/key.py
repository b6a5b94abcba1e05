"""One key: its default, its help text and its hint in the footer."""

from enum import Enum
from typing import Literal

from msgspec import Struct

from fleet_tui.text.language import EMPTY, N_, Message

LISTS = "lists orders"
"""A need: of robots that report their orders."""


class Pane(Enum):
    """The places in which keys work, with their titles in help."""

    CONSOLE = N_("Everywhere")
    ANYWHERE = N_("Everywhere, also while typing")
    """Works in text fields, forms and modals, too."""
    RECORDING = N_("The recording")
    """Everywhere, while a recording is played."""
    MAP = N_("Map")
    PLACE = N_("Pose (I), goal (G)")
    """On the map, while a place with a heading is chosen: they take precedence over all others."""
    EDIT = N_("Graph editor (E)")
    """On the map, while a draft is edited: they take precedence over all others."""
    DRIVE = N_("Driving by hand (T)")
    """On the map, while a robot is driven: they take precedence over all others, and any other key stops."""
    ROWS = N_("Tables: fleet, alarms, queue")
    DIAGNOSTICS = N_("Diagnostics (d)")
    HISTORY = N_("History (H)")

    @property
    def is_mode(self) -> bool:
        """Tell whether its keys belong to a mode of the map."""
        return self in (Pane.PLACE, Pane.EDIT, Pane.DRIVE)

    @property
    def is_everywhere(self) -> bool:
        """Tell whether its keys work with any focus."""
        return self in (Pane.CONSOLE, Pane.ANYWHERE, Pane.RECORDING)


class Key(Struct, frozen=True):
    """`id` names it in the config, and its action where its pane is made; `keys` are the defaults."""

    id: str
    keys: tuple[str, ...]
    text: Message
    pane: Pane = Pane.CONSOLE
    hint: Message = EMPTY
    """The footer's label, empty to be left out of the footer."""
    needs: str = ""
    """A verb that a robot must accept for the key to be offered, or LISTS."""
    of_any: bool = False
    """Offered as soon as one robot of the fleet has the need, else only for the selected robot."""
    commands: bool = False
    """Commands robots: hidden in the footer of a console without permission."""
    sets_up: bool = False
    """Sets robots up: hidden from a user without that right."""
    in_dialogs: bool = False
    """Works in menus, questions and other overlays, too: everywhere but in text fields."""
    helps: Literal["", "stays", "leaves"] = ""
    """Works while the reasons (`why`) are shown, which stay or are closed."""
    instead_of: str = ""
    """The id of a key with the same action, which needs AltGr on some keyboards: footer, help and palette
    name this one. It gives way to a key that the config assigns."""
    yields: bool = False
    """Gives way to another key that the config assigns its keys to."""
    always: bool = False
    """Shown at the right end of the footer."""
    in_palette: bool = True
    only_live: bool = False
    """Disabled while a recording is played."""
    of_map: bool = False
    """A key of the map that works from every pane."""
    of_rows: bool = False
    """A key of the tables that works from every pane."""

    @property
    def section(self) -> Pane:
        """Return the section of help that lists it."""
        return Pane.MAP if self.of_map else Pane.ROWS if self.of_rows else self.pane


_NAMES = {"escape": "Esc", "pageup": "PgUp", "pagedown": "PgDn"}


def key_name(key: str) -> str:
    """Return a key of the config as people write it: Ctrl-P, Shift-Tab, Esc, F1."""
    *modifiers, last = key.split("+") if len(key) > 1 else [key]
    if len(last) == 1:
        name = last.upper() if "ctrl" in modifiers else last
    else:
        name = _NAMES.get(last, last.capitalize())
    return "-".join([*(modifier.capitalize() for modifier in modifiers), name])
