from collections.abc import Callable
from functools import partial

from fleet_tui.features.drive.controls import DriveControls
from fleet_tui.keys import KEYS, Pane
from fleet_tui.keys.drive import PASSES, WHILE_HELD
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.screens.feature import Feature
from fleet_tui.ui.widgets.bindings import textual_key
from fleet_tui.ui.widgets.map_view import MapView


class HandDriving:
    """A robot driven by the arrow keys, on the map."""

    def __init__(
        self, console: Console, controls: MapControls, view: MapView, tell_releases: Callable[[bool], None]
    ) -> None:
        """`tell_releases` asks the terminal for the releases of keys."""

        def focus() -> None:
            # Later: a question gives the focus back to where it was.
            view.call_later(view.screen.set_focus, view)

        ids = {key.id for key in KEYS if key.pane is Pane.DRIVE} | PASSES
        self._keys = console.settings.keys
        self.controls = drives = DriveControls(
            console,
            controls=controls,
            picture=view.picture,
            focus=focus,
            is_shown=lambda: view.size.height > 0,
            passes=frozenset(textual_key(key) for id_ in ids for key in self._keys[id_]),
            tell_releases=tell_releases,
        )
        self.feature = Feature(
            actions={
                "drive": drives.start,
                **{id_: partial(drives.press, direction) for id_, direction in WHILE_HELD.items()},
                "drive_leave": drives.leave,
                "drive_faster": partial(drives.change_speed, 1),
                "drive_slower": partial(drives.change_speed, -1),
            },
            loss=lambda: Message("a robot is driven by hand") if drives.mode is not None else EMPTY,
        )

    def release_key(self, released: str) -> None:
        """Release the direction of a key, by Textual's name of it."""
        for id_, direction in WHILE_HELD.items():
            if released in map(textual_key, self._keys[id_]):
                self.controls.release(direction)

    def ended_before(self, reason: Message, do: Callable[[], object]) -> Callable[[], object]:
        """Return an action that ends a drive first."""

        def end_first() -> object:
            self.controls.end(reason)
            return do()

        return end_first
