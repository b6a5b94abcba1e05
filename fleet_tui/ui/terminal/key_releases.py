"""Key releases by the kitty keyboard protocol: asked for while a robot is driven, and told as messages.

Textual 8.2.8 does not ask for them, and its parser fails on one.
Source: https://sw.kovidgoyal.net/kitty/keyboard-protocol/#event-types
"""

import re
from collections.abc import Iterable
from importlib.metadata import version
from typing import cast

from textual import constants, events
from textual._xterm_parser import XTermParser
from textual.driver import Driver
from textual.drivers import linux_driver
from textual.message import Message

from fleet_tui.ui.terminal.display_driver import MADE_FOR

ALWAYS = 25
WITH_RELEASES = 27
"""Flags of the protocol: those that Textual asks for, and with event types."""
_WITH_TYPE = re.compile(r"(\x1b\[[\d:]*;\d*):(\d+)(.*)", re.DOTALL)
RELEASE = "3"


class KeyReleased(Message, bubble=False):
    """A key was released."""

    def __init__(self, key: str) -> None:
        super().__init__()
        self.key = key
        """Its name, as that of a press."""


class ReleaseParser(XTermParser):
    """Textual's parser of terminal input, which knows event types, too."""

    def _sequence_to_key_events(self, sequence: str, alt: bool = False) -> Iterable[events.Key]:
        found = _WITH_TYPE.fullmatch(sequence)
        if found is None:
            yield from super()._sequence_to_key_events(sequence, alt)
            return
        start, kind, rest = found.groups()
        for key in super()._sequence_to_key_events(start + rest, alt):
            # The driver passes on any message.
            yield key if kind != RELEASE else cast("events.Key", KeyReleased(key.key))


def parse_releases() -> None:
    """Let the driver of this version of Textual parse key releases."""
    if version("textual") == MADE_FOR:
        vars(linux_driver)["XTermParser"] = ReleaseParser


def tell_releases(driver: Driver | None, wanted: bool) -> None:
    """Ask the terminal to tell releases, or no longer. Terminals without the protocol ignore it."""
    parses = vars(linux_driver)["XTermParser"] is ReleaseParser and not constants.DISABLE_KITTY_KEY
    # A driver that has stopped has given the terminal back.
    if parses and isinstance(driver, linux_driver.LinuxDriver) and driver._writer_thread is not None:
        driver.write(f"\x1b[={WITH_RELEASES if wanted else ALWAYS};1u")
