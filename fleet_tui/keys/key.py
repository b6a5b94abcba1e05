"""A row of the table of keys, with all its columns."""

from collections.abc import Callable
from typing import Literal

from msgspec import Struct

from fleet_tui.actions import Actions

LISTS = "lists orders"
"""A need: of robots that say what they are to do."""


class Key(Struct, frozen=True):
    """`id` names it in the config; `keys` are the defaults. `action`: a call on the actions of the console;
    for "map", "table" and "diagnostics" Textual's action string of the pane's widget. `pane` is where it
    works: one of these, "console", "recording" (everywhere while one is played), or "anywhere", which reaches
    through text fields, forms and modals."""

    id: str
    keys: tuple[str, ...]
    action: Callable[[Actions], object] | str
    text: str
    pane: str = "console"
    hint: str = ""
    """The footer's word, empty to stay out of the footer."""
    needs: str = ""
    """A verb that a robot must accept for the key to be offered, or LISTS."""
    of_any: bool = False
    """Offered as soon as one robot of the fleet has what it needs, else only for the selected robot."""
    commands: bool = False
    """Commands robots: a console that can't does not hint at it."""
    eager: Literal["", "opens", "selects"] = ""
    """Comes before all else: it opens something to type in, and the next key may already be on its way; or it
    selects what that is opened for."""
    helps: Literal["", "stays", "leaves"] = ""
    """Works while the reasons (`why`) are shown, which stay or are left."""
    always: bool = False
    """Stands at the right end of the footer."""
    in_palette: bool = True
    only_live: bool = False
    """Means nothing while a recording is played."""
    of_map: bool = False
    """A key of the map that works from every pane."""

    @property
    def section(self) -> str:
        """The section of help that lists it."""
        return "map" if self.of_map else self.pane
