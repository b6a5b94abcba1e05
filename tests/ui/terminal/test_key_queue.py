"""Keys, the mouse and releases in their order: each meets what the one before it led to."""

import asyncio

from textual import events
from textual.app import ComposeResult
from textual.widgets import Static

from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.widgets.field import Field


class Slow(Static, can_focus=True):
    """Takes its time over each key, and then gives the focus away."""

    def __init__(self, done: list[str]) -> None:
        super().__init__("slow", id="slow")
        self._done = done

    async def on_key(self, event: events.Key) -> None:
        await asyncio.sleep(0)
        self._done.append(event.key)
        self.screen.set_focus(self.screen.query_one("#field"))


class App(LeanApp):
    def __init__(self) -> None:
        super().__init__()
        self.done: list[str] = []
        self.field = Field({"enter": lambda: self.screen.set_focus(self.query_one("#slow"))}, id="field")

    def compose(self) -> ComposeResult:
        yield Slow(self.done)
        yield self.field

    def press(self, *keys: str) -> None:
        for key in keys:
            self.post_message(events.Key(key, key if len(key) == 1 else None))


async def test_keys_of_one_read_meet_the_focus_that_each_has_led_to() -> None:
    async with (app := App()).run_test() as pilot:
        app.query_one("#slow").focus()
        await pilot.pause()
        app.press("x", "a", "b", "enter", "y", "c")
        await pilot.pause()
        assert (app.done, app.field.value) == (["x", "y"], "c"), "the focus selects what is there"


async def test_what_follows_a_key_waits_for_it() -> None:
    async with (app := App()).run_test() as pilot:
        app.field.focus()
        await pilot.pause()
        seen: list[str] = []
        await app.keys.take(events.Key("a", "a"))
        await app.keys.then(lambda: seen.append(app.field.value))
        assert seen == [], "the key is on its way"
        await pilot.pause()
        assert seen == ["a"]


async def test_a_widget_that_is_removed_by_its_key_holds_no_other_key_up() -> None:
    class Vanishing(Static, can_focus=True):
        def on_key(self) -> None:
            self.remove()

    async with (app := App()).run_test() as pilot:
        await app.mount(vanishing := Vanishing())
        vanishing.focus()
        await pilot.pause()
        app.press("x")
        await pilot.pause()
        app.field.focus()
        await pilot.pause()
        app.press("a")
        for _ in range(200):
            if app.field.value:
                break
            await pilot.pause(0.02)
        assert app.field.value == "a"
