"""The start of an app: a picture first, then the rest, once."""

import gc
from collections.abc import Iterator

import pytest
from textual.app import ComposeResult
from textual.theme import Theme
from textual.widgets import Static

from fleet_tui.ui.terminal.first_paint import YOUNG, FirstPaint
from fleet_tui.ui.terminal.lean_app import LeanApp


class Starting(LeanApp, inherit_bindings=False):
    """An app of one line and one more."""

    def __init__(self, colour: bool) -> None:
        super().__init__()
        self.mounted: list[tuple[bool, bool]] = []
        theme = Theme("plain", primary="#ffffff", dark=False)
        self.start = self.startup = FirstPaint(self, self.output, theme, colour, self._rest)

    def compose(self) -> ComposeResult:
        yield Static("first")

    async def _rest(self) -> None:
        self.mounted.append((self.start.painted.is_set(), self.output.ready))
        await self.screen.mount(Static("rest"))


@pytest.fixture
def usual_garbage() -> Iterator[None]:
    thresholds = gc.get_threshold()
    yield
    gc.set_threshold(*thresholds)
    gc.enable()


@pytest.mark.parametrize("colour", [True, False])
async def test_the_rest_comes_after_the_first_picture_and_once(colour: bool, usual_garbage: None) -> None:
    app = Starting(colour)
    assert app.output.ready is not colour, "without colours Textual's own picture would have some"
    gc.disable()
    async with app.run_test():
        app.start.painted.set()
        for _ in range(2):
            await app.start.finish()
        assert app.mounted == [(True, True)]
        assert gc.isenabled() and gc.get_threshold()[0] == YOUNG
        assert app.theme == "plain" and app.has_class("-light-mode") and not app.has_class("-dark-mode")
