"""The panes share the lines of the screen, and one may have its whole column."""

from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Row, Table
from fleet_tui.widgets.panes import Panes
from tests.support.widget_app import WidgetApp


def table(rows: int) -> Table:
    listed = [Row(str(n), ((f"row {n}", StyleRole.TEXT),)) for n in range(rows)]
    return Table((("Rows", StyleRole.TITLE),), listed, "none")


async def test_a_focused_pane_is_enlarged_and_comes_back() -> None:
    panes = Panes(3)
    async with WidgetApp(panes).run_test(size=(100, 40)) as pilot:
        tables = [table(3), table(1), table(2)]
        panes.show(tables, lambda: table(1))
        shared = panes.styles.grid_rows
        assert shared and not any(pane.has_class("-hidden") for pane in panes.children)
        panes.fleet.focus()
        await pilot.pause()
        panes.enlarge()
        panes.show(tables, lambda: table(1))
        hidden = {pane.id for pane in panes.children if pane.has_class("-hidden")}
        assert hidden == {"map", "alarms", "queue", "robot"} and panes.fleet.has_class("-across")
        panes.enlarge()
        panes.show(tables, lambda: table(1))
        assert panes.styles.grid_rows == shared
        assert not any(pane.has_class("-hidden") for pane in panes.children)


async def test_in_the_simple_interface_the_style_sheet_shares_them_out() -> None:
    panes = Panes(3)
    async with WidgetApp(panes).run_test(size=(100, 40)):
        panes.add_class("-simple")
        panes.show([table(3), table(1), table(2)], lambda: table(1))
        assert not panes.styles.has_rule("grid_rows")
