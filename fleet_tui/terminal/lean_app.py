"""The one place that reaches into Textual's private parts, and only into the version it was made for.

Stock Textual 8.2.8 resends a row from its widget's left edge when one cell of it changes, and
waits for the terminal as soon as 30 writes are queued: an SSH hiccup then stops the event loop.
"""

import inspect
import io
import sys
import time
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from rich.color import ColorSystem
from rich.console import RenderableType
from rich.control import Control
from textual import _ansi_sequences, _compositor, events
from textual.app import App
from textual.drivers._writer_thread import WriterThread
from textual.geometry import Offset
from textual.screen import Screen
from textual.strip import Strip
from textual.worker import WorkerFailed

if TYPE_CHECKING:
    from fleet_tui.terminal.budget import Budget
    from fleet_tui.terminal.glass import ScreenBuffer

MADE_FOR = "8.2.8"
RETRY, RETRY_LONGEST = 0.001, 0.016
"""Seconds until the next look whether the terminal reads again, twice as long each time."""

Part = tuple[int, int, int, Strip]
"""First cell, row, end cell, what is to be seen there."""

_COLOURS = {
    "standard": ColorSystem.STANDARD,
    "256": ColorSystem.EIGHT_BIT,
    "truecolor": ColorSystem.TRUECOLOR,
}


def textual_fits() -> bool:
    """Whether Textual is as this module needs it. If not, Textual paints by itself."""
    from importlib.metadata import version  # takes 6 ms

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


class LeanApp(App[None]):
    """Sends only the cells that changed, and never waits: frames are left out while nobody reads."""

    LEAN = True
    lean = True
    """The first picture may go Textual's way: what is needed here takes as long to import as to paint it."""

    _glass: "ScreenBuffer | None" = None
    _writer: object = None
    _cursor_sent = Offset(-1, -1)
    _retrying = False
    _patience = RETRY

    failure: Exception | None = None
    """What ended it, if that was an error."""

    def _handle_exception(self, error: Exception) -> None:
        if isinstance(error, WorkerFailed):
            self.worker_failed(error.error)
        else:
            self.failure = self.failure or error
            super()._handle_exception(error)

    def worker_failed(self, error: BaseException) -> None:
        """A worker ended with an error."""
        raise NotImplementedError

    def _fatal_error(self) -> None:
        """Leave. Textual would paint a traceback with the values of all variables, secrets among them."""
        self._close_messages_no_wait()

    def _display(self, screen: Screen[object], renderable: RenderableType | None) -> None:
        update = renderable if isinstance(renderable, _compositor.CompositorUpdate) else None
        shows = self._running and not self._closed and not self._batch_count
        if update is None or self.is_headless or self.is_inline or not self._paints_lean():
            super()._display(screen, renderable)
        else:
            try:
                if shows:
                    began = time.perf_counter()
                    self._want(update)
                    self._send()
                    self.budget.paints.take(time.perf_counter() - began)
            finally:
                self.post_display_hook()
        if update is not None and shows:
            self.on_painted()

    @cached_property
    def budget(self) -> "Budget":
        """What the pictures cost. Imported after the first one."""
        from fleet_tui.terminal.budget import Budget

        return Budget()

    def on_painted(self) -> None:
        """A picture has gone out."""

    def _paints_lean(self) -> bool:
        if self._glass is None and self.LEAN and self.lean:
            from fleet_tui.terminal.glass import ScreenBuffer

            self.LEAN = textual_fits()
            colours = None if self.no_color else _COLOURS.get(self.console.color_system or "")
            self._glass = ScreenBuffer(colours) if self.LEAN else None
            self.screen.refresh()
        return self._glass is not None

    def _want(self, update: _compositor.CompositorUpdate) -> None:
        assert self._glass is not None
        if isinstance(update, _compositor.LayoutUpdate):
            self._glass.fit(*update.region.size)
            parts = _all_parts(update)
        else:
            assert isinstance(update, _compositor.ChopsUpdate)
            self._glass.fit(update.chop_ends[0][-1], len(update.chops))
            parts = _changed_parts(update)
        for x, y, end, strip in parts:
            self._glass.put(x, y, end, strip)

    def _send(self) -> None:
        """Send what the terminal lacks, or try again soon."""
        driver, glass = self._driver, self._glass
        if driver is None or glass is None or self._retrying:
            return
        writer = getattr(driver, "_writer_thread", None)
        if writer is not self._writer:
            # The terminal was somebody else's in between (Ctrl-Z and fg).
            self._writer = writer
            glass.forget()
        if writer is not None and writer._queue.qsize():
            self._retrying = True
            self.budget.held += 1
            self.set_timer(self._patience, self._retry)
            self._patience = min(2 * self._patience, RETRY_LONGEST)
            return
        self._patience = RETRY
        sequence = glass.take()
        cursor = self.screen.outer_size.clamp_offset(self.cursor_position)
        if sequence or cursor != self._cursor_sent:
            self._cursor_sent = cursor
            sequence += Control.move_to(*cursor).segment.text
            if self._sync_available:
                sequence = f"{_ansi_sequences.SYNC_START}{sequence}{_ansi_sequences.SYNC_END}"
            driver.write(sequence)
            driver.flush()
            self.budget.sent.take(len(sequence.encode(errors="replace")), time.monotonic())

    def _retry(self) -> None:
        self._retrying = False
        self._send()

    def call(self, sequence: str) -> bool:
        """Send what changes nothing on the screen, like a bell. False while the terminal doesn't read."""
        driver = self._driver
        writer = getattr(driver, "_writer_thread", None)
        if driver is None or (writer is not None and writer._queue.qsize()):
            return False
        driver.write(sequence)
        driver.flush()
        return True

    def on_resize(self, _event: events.Resize) -> None:
        """Terminals rearrange what they show when their size changes, also there and back again."""
        self.action_repaint()

    def action_repaint(self) -> None:
        """Send every cell again: somebody else wrote on the terminal."""
        if self._glass is not None:
            self._glass.forget()
            self.screen.refresh()


def _all_parts(update: _compositor.LayoutUpdate) -> Iterator[Part]:
    for y, strips in enumerate(update.strips, update.region.y):
        x = update.region.x
        for strip in strips:
            yield x, y, x + strip.cell_length, strip
            x += strip.cell_length


def _changed_parts(update: _compositor.ChopsUpdate) -> Iterator[Part]:
    """Every part of a row that changed somewhere, whole."""
    for y, first, last in update.spans:
        for end, (x, strip) in zip(update.chop_ends[y], update.chops[y].items(), strict=True):
            if strip is not None and x < last and end > first:
                yield x, y, end, strip
