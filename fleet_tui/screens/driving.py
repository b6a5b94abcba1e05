"""The parts of the main screen with which a robot is driven by hand."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from fleet_tui.actions import DriveActions
from fleet_tui.controllers.driving.driving import DriveControls, DriveJournal
from fleet_tui.controllers.parts import SetUpParts
from fleet_tui.keys import KEYS, Pane
from fleet_tui.keys.drive import PASSES, WHILE_HELD
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.text.language import Message
from fleet_tui.widgets.bindings import textual_key

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen
    from fleet_tui.screens.rest import Rest


def drive_controls(screen: "MainScreen", rest: "Rest", parts: SetUpParts) -> DriveControls:
    def focus() -> None:
        # Later: a question gives the focus back to where it was.
        screen.call_later(screen.set_focus, rest.map)

    keys, app = screen.settings.keys, screen.app
    assert isinstance(app, LeanApp)
    ids = {key.id for key in KEYS if key.pane is Pane.DRIVE} | PASSES
    return DriveControls(
        parts,
        screen.backend,
        limits=screen.settings.drive,
        controls=rest.map_controls,
        picture=rest.map.picture,
        journal=DriveJournal(screen.files),
        ask=rest.confirm.ask,
        focus=focus,
        is_shown=lambda: rest.map.size.height > 0,
        passes=frozenset(textual_key(key) for id_ in ids for key in keys[id_]),
        tell_releases=app.tell_releases,
    )


def release_key(drives: DriveControls, keys: Mapping[str, tuple[str, ...]], released: str) -> None:
    """Release the direction of a key, by Textual's name of it."""
    for id_, direction in WHILE_HELD.items():
        if released in map(textual_key, keys[id_]):
            drives.release(direction)


def drive_actions(rest: "Rest") -> DriveActions:
    drives = rest.drives
    return DriveActions(
        start=drives.start, press=drives.press, change_speed=drives.change_speed, leave=drives.leave
    )


def after_a_drive(rest: "Rest", reason: Message, do: Callable[[], object]) -> Callable[[], object]:
    """Return an action that ends a drive first."""

    def end_first() -> object:
        rest.drives.end(reason)
        return do()

    return end_first
