"""A row of the table of keys, with all its columns."""

from collections.abc import Callable, Iterable
from enum import Enum
from typing import Generic, Literal, TypeVar

from msgspec import Struct

LISTS = "lists orders"
"""A need: of robots that say what they are to do."""


Doer = TypeVar("Doer")
"""The actions that a key calls one of."""


class Pane(Enum):
    """The places where keys work, with their titles in help."""

    CONSOLE = "Everywhere"
    ANYWHERE = "Everywhere, also while typing"
    """Reaches through text fields, forms and modals."""
    RECORDING = "The recording"
    """Everywhere, while one is played."""
    MAP = "Map"
    TABLE = "Tables: fleet, alarms, queue"
    DIAGNOSTICS = "Diagnostics (d)"

    @property
    def is_everywhere(self) -> bool:
        """Tell whether its keys work whatever has the focus."""
        return self in (Pane.CONSOLE, Pane.ANYWHERE, Pane.RECORDING)


class Key(Struct, Generic[Doer], frozen=True):
    """`id` names it in the config; `keys` are the defaults. `action` is a call on the actions of its pane:
    for tables and diagnostics those of the widget that has the focus, else those of the console."""

    id: str
    keys: tuple[str, ...]
    action: Callable[[Doer], object]
    text: str
    pane: Pane = Pane.CONSOLE
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
    def section(self) -> Pane:
        """The section of help that lists it."""
        return Pane.MAP if self.of_map else self.pane


def by_id(keys: Iterable[Key[Doer]]) -> dict[str, Key[Doer]]:
    """Return the keys of one table by their ids."""
    return {key.id: key for key in keys}
