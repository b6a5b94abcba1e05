"""Copies to the clipboard of the local terminal, also over ssh."""

from collections.abc import Callable
from functools import partial

from textual.message_pump import MessagePump

from fleet_tui.text.language import Message, tr
from fleet_tui.ui.terminal.clipboard import clipboard, copied_text
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.view.tables.listing import Listing

TRIES = 5
AGAIN_AFTER = 0.1
"""Copies while the terminal is still reading the last picture, and seconds between them."""


def copied_rows(listing: Listing) -> tuple[str, str]:
    """Return the marked rows, else that of the cursor, as a text, and its description."""
    text = listing.text
    rows = text.count("\n") + 1
    if rows > 1:
        return text, tr("{rows} rows, {count} characters", rows=rows, count=len(text))
    return text, tr("the row, {count} characters", count=len(text))


def copy(
    node: MessagePump, text: str, what: str, say: Callable[[Message], object], tries: int = TRIES
) -> None:
    """Copy a text, and say so; `what` describes it."""
    app = node.app
    assert isinstance(app, LeanApp)
    if not text:
        say(Message("nothing to copy"))
    elif app.output.call(clipboard(text)):
        say(copied_text(what))
    elif tries > 1:
        node.set_timer(AGAIN_AFTER, partial(copy, node, text, what, say, tries - 1))
    else:
        say(Message("not copied: the terminal is not reading"))
