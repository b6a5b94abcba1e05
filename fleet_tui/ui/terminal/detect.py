"""Detection of the terminal's capabilities."""

import codecs
import os
import shutil
import sys

from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message
from fleet_tui.ui.view.map.drawing import Drawing

COLOURLESS = ("dumb", "unknown", "vt100", "vt102", "vt220")
"""Terminals (TERM) without colour, to which Textual would send 24-bit colours."""
IN_BROWSER = "TEXTUAL_DRIVER"
"""Set by `fleet-tui serve`: pipes to a browser instead of a terminal."""

MULTIPLEXERS = {"tmux": "TMUX", "screen": "STY"}


def has_unicode() -> bool:
    """Tell whether the terminal shows more than ASCII: the Linux console's font and a plain locale don't."""
    try:
        unicode = codecs.lookup(sys.stdout.encoding or "ascii").name == "utf-8"
    except LookupError:
        unicode = False
    return unicode and os.environ.get("TERM") != "linux"


def drawing_for(wanted: str) -> Drawing:
    """Return the configured drawing, else braille if the terminal supports it."""
    if wanted != "auto":
        return Drawing(wanted)
    return Drawing.BRAILLE if has_unicode() else Drawing.ASCII


def has_colour() -> bool:
    """Tell whether colour is wanted and possible. An empty NO_COLOR has no effect; Textual only tests its
    presence."""
    if os.environ.get("TERM") in COLOURLESS:
        os.environ["NO_COLOR"] = "1"
    elif not os.environ.get("NO_COLOR"):
        os.environ.pop("NO_COLOR", None)
    return "NO_COLOR" not in os.environ


def description(drawing: Drawing, colour: bool) -> str:
    """Return a description of the terminal, and its consequences."""
    term, colorterm = os.environ.get("TERM", "not set"), os.environ.get("COLORTERM", "not set")
    size = shutil.get_terminal_size()
    inside = next((name for name, mark in MULTIPLEXERS.items() if os.environ.get(mark)), "none")
    return (
        f"Terminal: {size.columns} x {size.lines}, TERM {term}, COLORTERM {colorterm},"
        f" multiplexer {inside}, encoding {sys.stdout.encoding}.\n"
        f"Map drawing: {drawing.value} (change with m or --drawing). Colours:"
        f" {'on' if colour else 'off (NO_COLOR, or not supported)'}."
    )


def need_terminal() -> None:
    """Raise FleetError without a terminal."""
    streams = (sys.stdin, sys.stdout, sys.stderr)
    if IN_BROWSER not in os.environ and not all(stream.isatty() for stream in streams):
        raise FleetError(
            Message("the console needs a terminal for input, output and errors: over SSH use ssh -t")
        )
