"""A pane of rows: its cursor is reported, and a click marks, opens or presses."""

from collections.abc import Hashable

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Row, Table
from fleet_tui.ui.widgets.messages import RowChosen, RowPicked
from fleet_tui.ui.widgets.rows_pane import RowsPane
from tests.support.widget_app import WidgetApp, text


class Rows(WidgetApp):
    """Remembers what was picked and chosen."""

    def __init__(self, pane: RowsPane) -> None:
        super().__init__(pane)
        self.picked: list[Hashable] = []
        self.chosen: list[tuple[str, Hashable]] = []

    def on_row_picked(self, message: RowPicked) -> None:
        self.picked.append(message.key)

    def on_row_chosen(self, message: RowChosen) -> None:
        self.chosen.append((message.pane, message.key))


def table(*keys: str) -> Table:
    return Table(
        (("Rows", StyleRole.TITLE),), [Row(key, ((f"row {key}", StyleRole.TEXT),)) for key in keys], "none"
    )


async def test_the_cursor_is_reported_as_it_moves_and_its_row_is_opened() -> None:
    pane = RowsPane(id="queue")
    app = Rows(pane)
    async with app.run_test(size=(30, 8)) as pilot:
        pane.show(table("a", "b", "c"))
        pane.focus()
        await pilot.press("down", "down", "up", "enter")
        await pilot.pause()
        assert (app.picked, app.chosen) == (["b", "c", "b"], [("queue", "b")])
        assert "row c" in text(pane)[3]
        assert pane.row_width == pane.size.width - 1


async def test_a_click_marks_a_row_and_a_second_one_opens_it() -> None:
    pane = RowsPane(id="queue")
    app = Rows(pane)
    async with app.run_test(size=(30, 8)) as pilot:
        pane.show(table("a", "b"))
        await pilot.click("#queue", offset=(3, 2))
        assert app.picked == ["b"] and app.chosen == []
        await pilot.click("#queue", offset=(3, 2), times=2)
        await pilot.click("#queue", offset=(3, 5))
        assert set(app.picked) == {"b"} and app.chosen == [("queue", "b")]


async def test_who_gets_the_next_key_is_told_at_once() -> None:
    chosen: list[Hashable] = []
    pane = RowsPane(id="help", choose=chosen.append)
    async with Rows(pane).run_test(size=(30, 8)):
        pane.show(table())
        pane.open_menu()
        assert chosen == []
        pane.show(table("a"))
        pane.open_menu()
        assert chosen == ["a"]
