"""The notes of the others at the desk."""

import time
from collections.abc import Callable

from fleet_tui.model.history.facts import Note
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console

AT_ONCE = 60.0
"""Seconds within which a note has come at once: an older one, which waited for the folder, has its time."""


def join_desk(console: Console, call_later: Callable[[Callable[[], None]], object]) -> None:
    """Tell the desk, if there is one, which robot is looked at, and show the notes of the others."""
    desk, history = console.files.desk, console.files.history
    if desk is None:
        return

    newest: list[Note] = []

    def show_newest() -> None:
        taken, newest[:] = newest[-1:], []
        for note in taken:
            operator, remark = sanitize(note.operator), sanitize(note.text)
            if abs(time.time() - note.at) < AT_ONCE:
                console.notices.say(Message("note of {operator}: {remark}", operator=operator, remark=remark))
            else:
                when = console.settings.clock(note.at)
                console.notices.say(
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
                call_later(show_newest)

    desk.selected = lambda: console.navigation.robot
    desk.on_note = take_note
