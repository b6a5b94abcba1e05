"""Screens before the console: rows that fill the page at any size, above their keys."""

from collections.abc import Sequence

import pytest
from textual.app import App
from textual.screen import Screen

from fleet_tui.ui.screens.opening import RowsScreen
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run
from tests.support.widget_app import text


class Page(RowsScreen):
    """Says how large it is."""

    def rows(self, width: int, height: int) -> Sequence[Sequence[Run]]:  # type: ignore[override]  # any rows will do
        return [[(f"{width} x {height}".ljust(width), StyleRole.TEXT)]]


class Before(App[None]):
    """One such screen."""

    def get_default_screen(self) -> Screen[None]:
        return Page(load_themes(None)[0]["dark"].styles(), (("enter", "open"), ("q", "quit")))


@pytest.mark.parametrize("size", [(80, 24), (20, 3)])
async def test_rows_fill_the_page_and_keys_stand_below(size: tuple[int, int]) -> None:
    async with Before().run_test(size=size) as pilot:
        await pilot.pause()
        page = pilot.app.screen
        assert isinstance(page, Page)
        assert text(page.page)[0].strip() == f"{size[0]} x {size[1] - 1}"
        assert "enter open" in text(page.query_one("#keys"))[0] and page.focused is None
        await pilot.resize_terminal(40, 10)
        await pilot.pause()
        assert text(page.page)[0].strip() == "40 x 9"
