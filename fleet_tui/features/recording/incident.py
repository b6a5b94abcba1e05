"""Packs the files for an incident ticket into an archive, by one key."""

import logging
from collections.abc import Callable
from functools import partial
from pathlib import Path

from fleet_tui.text.language import Message
from fleet_tui.text.units import size_text
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.files import Pack

LOG = logging.getLogger(__name__)

Cancelled = Callable[[], bool]


class IncidentPacking:
    """Packs in a thread, one at a time."""

    def __init__(
        self,
        console: Console,
        screenshot: Callable[[], str],
        in_thread: Callable[[Callable[[Cancelled], None]], object],
    ) -> None:
        """`in_thread` runs a function, passing it a check for cancellation."""
        self._files = console.files
        self._say = console.notices.say
        self._say_from_thread = console.say_from_thread
        self._screenshot = screenshot
        self._in_thread = in_thread
        self._packing = False

    def pack(self) -> None:
        """Pack the files of an incident into one archive."""
        pack = self._files.pack
        if pack is None:
            self._say(Message("nothing to pack: not a live console"))
        elif self._files.refusal:
            self._say(self._files.refusal)
        elif self._packing:
            self._say(Message("still packing: the doctor takes up to 10 s"))
        else:
            self._packing = True
            shot = self._screenshot()
            self._say(Message("packing an incident: the doctor runs first, up to 10 s"))
            self._in_thread(partial(self._pack, pack, shot))

    def _pack(self, pack: Pack, shot: str, is_cancelled: Cancelled) -> None:
        """Pack, in a thread."""
        try:
            path = pack(shot, is_cancelled)
            # The usual path fits 80 columns.
            where = str(path).replace(str(Path.home()), "~", 1)
            said: Message = Message(
                "packed {size_text}: {where}", size_text=size_text(path.stat().st_size), where=where
            )
        except Exception as problem:
            # The operator sees any error, and may try again.
            LOG.exception("packing")
            said = Message("incident not packed: {problem}", problem=problem)
        LOG.info("%s", said)
        self._packing = False
        if not is_cancelled():
            self._say_from_thread(said)
