"""The display driver: sends changed cells, and holds them back while the terminal is not read.

With `key_releases` the only module that uses Textual's private parts (`lean_app` calls both), and only of
the version they were made for.

Stock Textual 8.2.8 resends a row from its widget's left edge when one cell of it changes, and waits for the
terminal as soon as 30 writes are queued: an SSH hiccup then stops the event loop.
"""

import inspect
import io
import sys
import time
from collections.abc import Callable, Iterator
from functools import cached_property
from importlib.metadata import version
from typing import TYPE_CHECKING

from rich.color import ColorSystem
from rich.control import Control
from textual import _ansi_sequences, _compositor
from textual.app import App
from textual.drivers._writer_thread import WriterThread
from textual.geometry import Offset
from textual.strip import Strip

from fleet_tui.ui.terminal.budget import Budget

if TYPE_CHECKING:
    from fleet_tui.ui.terminal.screen_buffer import ScreenBuffer

MADE_FOR = "8.2.8"
RETRY = 0.001
RETRY_LONGEST = 0.016
"""Seconds until the next check whether the terminal reads again, doubled each time."""

Part = tuple[int, int, int, Strip]
"""First cell, row, end cell, visible content."""

_COLOURS = {
    "standard": ColorSystem.STANDARD,
    "256": ColorSystem.EIGHT_BIT,
    "truecolor": ColorSystem.TRUECOLOR,
}


def textual_fits() -> bool:
    """Tell whether Textual matches this module. If not, Textual paints by itself."""
    try:
        signatures = (
            (_compositor.LayoutUpdate, ["strips", "region"]),
            (_compositor.ChopsUpdate, ["chops", "spans", "chop_ends"]),
            (App._display, ["self", "screen", "renderable"]),
        )
        names = (_ansi_sequences.SYNC_START, WriterThread(io.StringIO())._queue.qsize)
    except AttributeError:
        return False
    return (
        version("textual") == MADE_FOR
        and sys.platform != "win32"
        and all(names)
        and all(list(inspect.signature(part).parameters) == names for part, names in signatures)
    )


class DisplayDriver:
    """Sends only the cells that changed, and never waits: frames are skipped while the terminal does not
    read."""

    def __init__(self, app: App[None], wanted: bool) -> None:
        """`wanted`: if False, Textual paints by itself."""
        self._app = app
        self._wanted = wanted
        self.ready = True
        """False lets the first picture go Textual's way: the imports here take as long as to paint it."""
        self.buffer: ScreenBuffer | None = None
        self._writer: object = None
        self._cursor_sent = Offset(-1, -1)
        self._retrying = False
        self._unread_since: float | None = None
        """Since when the terminal has not read what was sent (monotonic)."""
        self.read_again: Callable[[float], None] = lambda seconds: None
        """Called with the seconds for which the terminal did not read, once it reads again."""
        self._patience = RETRY

    @cached_property
    def budget(self) -> Budget:
        """Return the costs of the pictures."""
        return Budget()

    def paints(self) -> bool:
        """Tell whether it paints; if not, Textual does."""
        app = self._app
        if self.buffer is None and self._wanted and self.ready:
            from fleet_tui.ui.terminal.screen_buffer import ScreenBuffer

            self._wanted = textual_fits()
            colours = None if app.no_color else _COLOURS.get(app.console.color_system or "")
            self.buffer = ScreenBuffer(colours) if self._wanted else None
            app.screen.refresh()
        return self.buffer is not None

    def show(self, update: _compositor.CompositorUpdate) -> None:
        """Send the changes of an update."""
        began = time.perf_counter()
        self._want(update)
        self._send()
        self.budget.paints.take(time.perf_counter() - began)

    def _want(self, update: _compositor.CompositorUpdate) -> None:
        assert self.buffer is not None
        if isinstance(update, _compositor.LayoutUpdate):
            self.buffer.fit(*update.region.size)
            parts = _all_parts(update)
        else:
            assert isinstance(update, _compositor.ChopsUpdate)
            self.buffer.fit(update.chop_ends[0][-1], len(update.chops))
            parts = _changed_parts(update)
        for x, y, end, strip in parts:
            self.buffer.put(x, y, end, strip)

    def _send(self) -> None:
        """Send the differences to the terminal, or try again soon."""
        app, buffer = self._app, self.buffer
        driver = app._driver
        if driver is None or buffer is None or self._retrying:
            return
        writer = getattr(driver, "_writer_thread", None)
        if writer is not self._writer:
            # Another program used the terminal in between (Ctrl-Z and fg).
            self._writer = writer
            buffer.forget()
        if writer is not None and writer._queue.qsize():
            self._retrying = True
            self._unread_since = self._unread_since or time.monotonic()
            self.budget.held += 1
            app.set_timer(self._patience, self._retry)
            self._patience = min(2 * self._patience, RETRY_LONGEST)
            return
        self._patience = RETRY
        if self._unread_since is not None:
            unread_for, self._unread_since = self.unread_for(), None
            self.read_again(unread_for)
        sequence = buffer.take()
        cursor = app.screen.outer_size.clamp_offset(app.cursor_position)
        if sequence or cursor != self._cursor_sent:
            self._cursor_sent = cursor
            sequence += Control.move_to(*cursor).segment.text
            if app._sync_available:
                sequence = f"{_ansi_sequences.SYNC_START}{sequence}{_ansi_sequences.SYNC_END}"
            driver.write(sequence)
            driver.flush()
            self.budget.sent.take(len(sequence.encode(errors="replace")), time.monotonic())

    def unread_for(self) -> float:
        """Return the seconds for which the terminal has not read what was sent."""
        return 0.0 if self._unread_since is None else time.monotonic() - self._unread_since

    def _retry(self) -> None:
        self._retrying = False
        self._send()

    def call(self, sequence: str) -> bool:
        """Send bytes without effect on the screen, like a bell. False while the terminal doesn't read."""
        driver = self._app._driver
        writer = getattr(driver, "_writer_thread", None)
        if driver is None or (writer is not None and writer._queue.qsize()):
            return False
        driver.write(sequence)
        driver.flush()
        return True

    def repaint(self) -> None:
        """Send every cell again: another program wrote on the terminal."""
        if self.buffer is not None:
            self.buffer.forget()
            self._app.screen.refresh()


def _all_parts(update: _compositor.LayoutUpdate) -> Iterator[Part]:
    for y, strips in enumerate(update.strips, update.region.y):
        x = update.region.x
        for strip in strips:
            yield x, y, x + strip.cell_length, strip
            x += strip.cell_length


def _changed_parts(update: _compositor.ChopsUpdate) -> Iterator[Part]:
    """Return every changed part of a row, whole."""
    for y, first, last in update.spans:
        for end, (x, strip) in zip(update.chop_ends[y], update.chops[y].items(), strict=True):
            if strip is not None and x < last and end > first:
                yield x, y, end, strip
