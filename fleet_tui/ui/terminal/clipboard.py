"""The clipboard of the terminal, also over ssh (OSC 52)."""

import base64
import os

from fleet_tui.text.language import EMPTY, Message


def clipboard(text: str) -> str:
    """Return the bytes that put a text into the terminal's clipboard."""
    return f"\x1b]52;c;{base64.b64encode(text.encode(errors='replace')).decode()}\x07"


def copied_text(what: str) -> Message:
    """Return the notice of a copy, with what tmux needs for it."""
    tmux = Message(" (tmux needs: set -s set-clipboard on)") if "TMUX" in os.environ else EMPTY
    return Message("copied to the clipboard{tmux}: {what}", tmux=tmux, what=what)
