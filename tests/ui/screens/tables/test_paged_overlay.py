"""An overlay of pages has its widgets in their order, whatever it shows."""

from textual.app import App, ComposeResult

from fleet_tui.ui.screens.tables.paged_overlay import PagedOverlay
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Row, Table


class Things(PagedOverlay):
    def look(self) -> None:
        self.rows.show(Table((), [Row(n, ((str(n), StyleRole.TEXT),)) for n in "ab"]))


class Paged(App[None]):
    def __init__(self) -> None:
        super().__init__()
        self.chosen: list[object] = []
        self.pages = Things("things", self.chosen.append, 1.0, self.chosen.append)

    def compose(self) -> ComposeResult:
        yield self.pages


async def test_its_parts_and_what_enter_chooses() -> None:
    app = Paged()
    async with app.run_test() as pilot:
        names = [one.id for one in app.pages.walk_children() if one.id]
        assert names == ["things-pages", "things-filter", "things-rows", "things-beside", "things-keys"]
        assert not app.pages.beside.display, "it is for overlays with a second page"
        app.pages.set_role_styles({})
        app.pages.begin(app.pages.rows)
        await pilot.press("down", "enter")
        assert app.chosen == ["b"]
