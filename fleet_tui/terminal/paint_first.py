"""Paints a first picture before everything is imported, and keeps what is typed until it is."""

import asyncio
import gc
from contextlib import ExitStack

from textual import events
from textual.theme import Theme

from fleet_tui.terminal.lean_app import LeanApp

YOUNG = 10_000
"""New objects between two looks for garbage. A tick of a large fleet makes thousands, and no cycles."""


class PaintFirst(LeanApp):
    """The first picture, then `mount_rest`, then the keys that came meanwhile, in their order."""

    def __init__(self, theme: Theme, ansi_color: bool) -> None:
        super().__init__(ansi_color=ansi_color)
        # Before the style sheet is read, or all of it would be read and applied twice.
        self.register_theme(theme)
        self.set_reactive(LeanApp.theme, theme.name)
        self.stylesheet.set_variables(self.get_css_variables())
        self.set_class(theme.dark, "-dark-mode")
        self.set_class(not theme.dark, "-light-mode")
        # Textual keeps no colour out of a picture, if none is wanted.
        self.lean = ansi_color
        self._painted = asyncio.Event()
        self._stands = False
        self._held = ExitStack()
        self._held.enter_context(self.batch_update())

    def show_first(self) -> None:
        """What there is may be painted now."""
        self._held.close()

    def on_painted(self) -> None:
        """Something stands on the screen."""
        self._painted.set()

    async def mount_rest(self) -> None:
        """Get everything else."""
        raise NotImplementedError

    async def stand(self) -> None:
        """Paint, and get everything, unless that is done."""
        if self._stands:
            return
        self._stands = True
        self.show_first()
        self.screen.refresh()
        await self._painted.wait()
        self.lean = True
        # Collecting garbage while so much was imported would have gone through it again and again.
        if not gc.isenabled():
            gc.freeze()
            gc.enable()
        gc.set_threshold(YOUNG)
        await self.mount_rest()

    async def on_event(self, event: events.Event) -> None:
        """What is typed waits until it finds what it is meant for."""
        if isinstance(event, events.InputEvent | events.Paste):
            await self.stand()
        await super().on_event(event)
