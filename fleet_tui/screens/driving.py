"""Driving by hand on this screen."""

from fleet_tui.controllers.console import Console
from fleet_tui.controllers.driving.driving import DriveControls
from fleet_tui.controllers.map import MapControls
from fleet_tui.keys import KEYS, Pane
from fleet_tui.keys.drive import PASSES
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.widgets.bindings import textual_key
from fleet_tui.widgets.map_view import MapView


def drive_controls(console: Console, app: LeanApp, map_view: MapView, controls: MapControls) -> DriveControls:
    def focus() -> None:
        # Later: a question gives the focus back to where it was.
        map_view.call_later(map_view.screen.set_focus, map_view)

    ids = {key.id for key in KEYS if key.pane is Pane.DRIVE} | PASSES
    return DriveControls(
        console,
        controls=controls,
        picture=map_view.picture,
        focus=focus,
        is_shown=lambda: map_view.size.height > 0,
        passes=frozenset(textual_key(key) for id_ in ids for key in console.settings.keys[id_]),
        tell_releases=app.tell_releases,
    )
