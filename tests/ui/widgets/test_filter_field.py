"""A field that filters rows, in an app of its own."""

import pytest
from textual.actions import SkipAction
from textual.app import App, ComposeResult
from textual.widgets import Input

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Row, Table
from fleet_tui.ui.widgets.filter_field import FilterField
from fleet_tui.ui.widgets.rows_pane import RowsPane


class Filtered(App[None]):
    AUTO_FOCUS = "#rows"

    def __init__(self) -> None:
        super().__init__()
        self.rows = RowsPane(id="rows")
        self.field = FilterField(self.rows, id="field", keys={"escape": lambda: self.field.leave(clear=True)})
        self.typed: list[str] = []

    def compose(self) -> ComposeResult:
        yield self.field
        yield self.rows

    def on_input_changed(self, event: Input.Changed) -> None:
        self.typed.append(event.value)


async def test_it_is_there_while_it_is_used_and_the_rows_move_meanwhile() -> None:
    app = Filtered()
    async with app.run_test() as pilot:
        app.rows.show(Table((), [Row(n, ((str(n), StyleRole.TEXT),)) for n in range(30)]))
        assert not app.field.display
        app.field.begin()
        await pilot.press("a", "down", "down", "pagedown", "up")
        in_view = app.rows.size.height - 1
        assert 1 < in_view < 29, "there is more than is in view"
        assert app.field.display and app.typed == ["a"] and app.rows.listing.cursor == 1 + in_view
        with pytest.raises(SkipAction):
            app.field.begin()
        await pilot.press("enter")
        assert app.screen.focused is app.rows and app.field.display
        app.field.begin()
        await pilot.press("escape")
        assert app.screen.focused is app.rows and not app.field.display and app.typed == ["a", ""]


async def test_keys_of_rows_move_by_those_in_view_and_to_both_ends() -> None:
    app = Filtered()
    async with app.run_test() as pilot:
        app.rows.show(Table((), [Row(n, ((str(n), StyleRole.TEXT),)) for n in range(100)]))
        in_view = app.rows.size.height - 1
        for key, row in (("pagedown", in_view), ("end", 99), ("pageup", 99 - in_view), ("home", 0)):
            await pilot.press(key)
            assert app.rows.listing.cursor == row


async def test_a_text_that_is_put_tells_nobody() -> None:
    app = Filtered()
    async with app.run_test() as pilot:
        app.field.put("robot_1")
        await pilot.pause()
        assert app.field.display and app.field.value == "robot_1" and app.typed == []
