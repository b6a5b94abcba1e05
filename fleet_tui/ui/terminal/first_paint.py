"""Start of an app: a first picture before everything is imported; typed keys are kept until then."""

import asyncio
import gc
from collections.abc import Awaitable, Callable
from contextlib import ExitStack

from textual.app import App
from textual.theme import Theme

from fleet_tui.ui.terminal.display_driver import DisplayDriver

YOUNG = 1_000_000
"""New objects between two of Python's own garbage collections, which stop all threads for up to 40 ms with
500 robots: the client collects once a minute. A tick of a large fleet makes thousands, and no cycles."""


class FirstPaint:
    """The first picture, then `mount_rest`, then the keys typed meanwhile, in their order."""

    def __init__(
        self,
        app: App[None],
        output: DisplayDriver,
        theme: Theme,
        colour: bool,
        mount_rest: Callable[[], Awaitable[None]],
    ) -> None:
        # Before the style sheet is read: otherwise it would be read and applied twice.
        app.register_theme(theme)
        app.set_reactive(App.theme, theme.name)
        app.stylesheet.set_variables(app.get_css_variables())
        app.set_class(theme.dark, "-dark-mode")
        app.set_class(not theme.dark, "-light-mode")
        # Textual has no way to suppress colours in a picture.
        output.ready = not colour
        self._app = app
        self._output = output
        self._mount_rest = mount_rest
        self.painted = asyncio.Event()
        """Set once a picture has been written."""
        self._finished = False
        self._held = ExitStack()
        self._held.enter_context(app.batch_update())

    def show(self) -> None:
        """Paint the existing widgets now."""
        self._held.close()

    async def finish(self) -> None:
        """Paint, and mount the rest, unless that is done."""
        if self._finished:
            return
        self._finished = True
        self.show()
        self._app.screen.refresh()
        await self.painted.wait()
        self._output.ready = True
        if not gc.isenabled():
            gc.freeze()  # the imports stay as long as the console
            gc.enable()
        gc.set_threshold(YOUNG)
        await self._mount_rest()
