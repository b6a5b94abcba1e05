"""A text field: its keys act at once, late keys go where the focus is, and pasted text acts on nobody."""

from collections.abc import Callable

from textual import events
from textual.screen import Screen

from fleet_tui.ui.widgets.field import Field
from tests.support.widget_app import WidgetApp, screen_rows


async def test_a_bound_key_acts_and_the_others_are_typed() -> None:
    done: list[str] = []
    keys: dict[str, Callable[[], object]] = {"enter": lambda: done.append("enter")}
    field = Field(keys, id="field")
    async with WidgetApp(field).run_test() as pilot:
        field.focus()
        await pilot.press("a", "b", "enter", "c")
        assert (done, field.value) == (["enter"], "abc")


async def test_keys_in_the_queue_follow_the_focus() -> None:
    second = Field({}, id="second")
    app = WidgetApp(first := Field({"enter": lambda: first.screen.set_focus(second)}, id="first"), second)
    async with app.run_test() as pilot:
        first.focus()
        await pilot.pause()
        for key, character in (("a", "a"), ("enter", None), ("b", "b"), ("c", "c")):
            app.post_message(events.Key(key, character))
        await pilot.pause()
        assert (first.value, second.value) == ("a", "bc")


async def test_editing_keys_of_one_burst_keep_their_place_among_letters() -> None:
    app = WidgetApp(field := Field({}, id="field"))
    async with app.run_test() as pilot:
        field.focus()
        await pilot.pause()
        # As a driver does it with all keys of one read.
        for key in ("l", "a", "u", "backspace", "backspace", "backspace", "k", "t", "left", "i", "end", "c"):
            app.post_message(events.Key(key, key if len(key) == 1 else None))
        await pilot.pause()
        assert field.value == "kitc"


async def test_pasted_text_is_made_visible() -> None:
    field = Field({}, id="field")
    async with WidgetApp(field).run_test() as pilot:
        field.focus()
        await pilot.pause()
        field.post_message(events.Paste("Base\x1b[2J\u202e"))
        await pilot.pause()
        assert field.value.startswith("Base␛[2J") and "\u202e" not in field.value


async def test_a_letter_lays_no_screen_out_and_a_long_text_slides() -> None:
    """A new layout paints every widget of the screen: of a large one, that takes longer than a key may."""
    field = Field({}, id="field")
    async with WidgetApp(field).run_test(size=(20, 5)) as pilot:
        field.focus()
        await pilot.pause()
        layouts: list[Screen[object]] = []
        field.screen.screen_layout_refresh_signal.subscribe(field, layouts.append)
        await pilot.press(*"abcdefghijklmnopqrstuvwxyz")
        await pilot.pause()
        shown = screen_rows(pilot.app)[field.region.y]
        assert layouts == [] and "xyz" in shown and "abc" not in shown
