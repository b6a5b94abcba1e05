"""The parts of the main screen that belong to the desk."""

import time
from typing import TYPE_CHECKING

from fleet_tui.controllers.desk.commands import DeskCommands
from fleet_tui.controllers.parts import SetUpParts
from fleet_tui.controllers.tables.facilities import FacilityList
from fleet_tui.model.history.facts import Note
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize

AT_ONCE = 60.0
"""Seconds within which a note has come at once: an older one, which waited for the folder, has its time."""

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen


def desk_and_facilities(screen: "MainScreen", parts: SetUpParts) -> tuple[DeskCommands, FacilityList]:
    """Return the typed lines of the desk on this screen, and the list of a site's lifts and doors."""
    clock = screen.settings.clock
    return DeskCommands(parts, screen.files, screen.backend.post, clock), FacilityList(parts, clock)


def join_desk(screen: "MainScreen") -> None:
    """Tell the desk, if there is one, which robot is looked at, and show the notes of the others."""
    desk, history = screen.files.desk, screen.files.history
    if desk is None:
        return

    newest: list[Note] = []

    def show_newest() -> None:
        taken, newest[:] = newest[-1:], []
        for note in taken:
            operator, remark = sanitize(note.operator), sanitize(note.text)
            if abs(time.time() - note.at) < AT_ONCE:
                screen.notices.say(Message("note of {operator}: {remark}", operator=operator, remark=remark))
            else:
                when = screen.settings.clock(note.at)
                screen.notices.say(
                    Message(
                        "note of {operator}, {when}: {remark}", operator=operator, when=when, remark=remark
                    )
                )

    def take_note(note: Note, is_new: bool) -> None:
        if history is not None:
            history.add_note(note.text, note.operator, note.at)
        if is_new:
            newest.append(note)
            if len(newest) == 1:  # many at once are one look at the screen: each would hide the one before
                screen.call_later(show_newest)

    desk.selected = lambda: screen.navigation.robot
    desk.on_note = take_note
