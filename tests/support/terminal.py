"""A terminal that tests can look at: what an app writes is played into pyte."""

import asyncio
from itertools import chain
from queue import Queue
from types import SimpleNamespace
from unicodedata import normalize

import pyte
from rich.cells import split_graphemes
from rich.style import Style
from textual import events
from textual.app import App
from textual.driver import Driver
from textual.geometry import Size
from textual.widget import Widget

Cell = tuple[str, str, str, bool, bool, bool]
"""Text, colour and ground as rrggbb or a name, bold, reverse, underline."""


class PlayedDriver(Driver):
    """Textual's way to a terminal of `size`; it can be told not to read."""

    def start_application_mode(self) -> None:
        width, height = self._size or (80, 24)
        self.screen = pyte.Screen(width, height)
        self._stream = pyte.Stream(self.screen)
        self.written: list[str] = []
        self.waiting: Queue[str | None] = Queue()
        self.reads = True
        # As in Textual's own driver: what the terminal has not read yet.
        self._writer_thread = SimpleNamespace(_queue=self.waiting)
        self._say_size(width, height)

    def _say_size(self, width: int, height: int) -> None:
        size = Size(width, height)
        asyncio.get_running_loop().create_task(self._app._post_message(events.Resize(size, size)))

    def resize(self, width: int, height: int) -> None:
        """The person pulls at the window."""
        self.screen.resize(height, width)
        self._say_size(width, height)

    def read_again(self) -> None:
        """The terminal reads what is waiting, and everything from now on."""
        self.reads = True
        while not self.waiting.empty():
            self.write(self.waiting.get() or "")

    def write(self, data: str) -> None:
        if self.reads:
            self.written.append(data)
            self._stream.feed(data)
        else:
            self.waiting.put(data)

    def disable_input(self) -> None: ...

    def stop_application_mode(self) -> None: ...


def terminal_of(app: App[None]) -> PlayedDriver:
    """The terminal that an app runs on."""
    assert isinstance(app._driver, PlayedDriver)
    return app._driver


def paint(app: App[None], *changed: Widget) -> None:
    """One of Textual's 60 updates a second, without the wait."""
    app.screen._dirty_widgets.update(changed)
    app.screen._on_timer_update()


def shown(terminal: PlayedDriver) -> list[list[Cell]]:
    """The text on the terminal, row by row."""
    screen = terminal.screen
    return [
        [
            (cell.data, cell.fg, cell.bg, cell.bold, cell.reverse, cell.underscore)
            for cell in (screen.buffer[y][x] for x in range(screen.columns))
        ]
        for y in range(screen.lines)
    ]


def intended(app: App[None]) -> list[list[Cell]]:
    """The picture that Textual intends; full blocks are sent on a ground of their own colour."""
    strips = app.screen._compositor.render_strips()
    return [list(chain.from_iterable(_cells(text, style) for text, style, _ in strip)) for strip in strips]


def _cells(text: str, style: Style | None) -> list[Cell]:
    style = style or Style.null()
    color, on = (
        "default" if part is None or part.is_default else part.get_truecolor().hex.lstrip("#")
        for part in (style.color, style.bgcolor)
    )
    look = bool(style.bold), bool(style.reverse), bool(style.underline)
    # NFC, because pyte keeps letters and their marks so.
    parts = ((normalize("NFC", text[start:end]), width) for start, end, width in split_graphemes(text)[0])
    return [
        (part if x == 0 else "", color, color if part == "█" else on, *look)
        for part, width in parts
        for x in range(width)
    ]
