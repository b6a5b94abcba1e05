"""The routines: a list with the progress of each robot, and a text about one of them."""

import time
from collections.abc import Hashable, Sequence
from typing import ClassVar

from textual.binding import BindingType

from fleet_tui.config.log_file import state_folder
from fleet_tui.features.routines.folder import RoutinePlace
from fleet_tui.features.routines.led import LedRoutines
from fleet_tui.features.routines.requests import RoutineRequests
from fleet_tui.features.routines.table import routine_table, text_table
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.local_time import since_text
from fleet_tui.ui.screens.overlay import ReturningOverlay
from fleet_tui.ui.screens.tables.paged_overlay import TableOverlay
from fleet_tui.ui.widgets.bindings import overlay_bindings

EVERY = 0.25
"""Seconds between two ticks of the routines."""
LOOK_EVERY = 2.0
"""Seconds between two looks at the files."""


class Routines(ReturningOverlay, TableOverlay):
    """One table: the routines, or the lines of a text about one. What runs here goes on while it is
    closed."""

    BINDINGS: ClassVar[list[BindingType]] = [("escape,q", "back", "Back"), *overlay_bindings("routines")]

    def __init__(self, console: Console) -> None:
        super().__init__("routines", self._choose, EVERY, console.notices.say)
        settings = console.settings
        self._place = RoutinePlace(settings.routines, state_folder() / "routines", settings.doubt)
        self._led = LedRoutines(self._place, console)
        self._requests = RoutineRequests(self._place, console, self._led)
        self._ask = console.ask
        self._text: tuple[Message, Sequence[str]] = EMPTY, ()
        self._looked = 0.0

    def show(self) -> None:
        """Open on the list."""
        self.leave_page()
        self._looked = 0.0
        self._requests.tick()
        self.begin(self.rows)

    def show_text(self, title: Message, lines: Sequence[str]) -> None:
        """Show a text in the place of the list."""
        self._text = title, lines
        self.open(self.rows)
        self.enter_page()
        self.look()

    def _choose(self, key: Hashable) -> None:
        match key:
            case str():
                self._requests.menu(key, "", self.show_text)
            case (str() as name, str() as robot):
                self._requests.menu(name, robot, self.show_text)

    def tick(self) -> None:
        """What runs goes on while it is closed."""
        self._requests.tick()
        super().tick()

    def tick_closed(self) -> bool:
        return True

    def look(self) -> None:
        """Show the current rows."""
        if time.monotonic() - self._looked > LOOK_EVERY:
            self._looked = time.monotonic()
            self._requests.look()
        if self.is_on_page:
            table = text_table(*self._text, arrangement=self.rows.arrangement)
        else:
            shown = self._requests.rows, str(self._place.folder), since_text
            table = routine_table(*shown, self.rows.row_width, self.rows.arrangement)
        self.rows.show(table)
        cursor = self.rows.listing.cursor
        marked = next((row for row in table.rows if row.key == cursor), None)
        self.note(marked.runs[-1][0] if marked is not None else "")

    @property
    def has_losses(self) -> bool:
        """Tell whether a routine runs here, which would not go on without this console."""
        return bool(self._led.losses)

    def quit(self) -> None:
        """Leave the program, after a question if a routine runs here."""
        if self._led.losses:
            self._ask(lambda: self._led.losses, self.app.exit)
        else:
            self.app.exit()

    def on_unmount(self) -> None:
        """Leave what runs here."""
        self._led.close()
