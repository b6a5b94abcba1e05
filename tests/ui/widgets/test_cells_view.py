"""Pictures in cells: only the cells that changed are sent."""

import pytest
from textual.geometry import Region

from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.cells_view import CellsView
from tests.support.widget_app import WidgetApp, text


def cells(*rows: str) -> Cells:
    made = Cells.blank(len(rows[0]), len(rows), StyleRole.TEXT)
    for y, row in enumerate(rows):
        made.write(0, y, row, StyleRole.TEXT)
    return made


async def test_a_picture_is_shown_and_its_differences_alone_are_sent(monkeypatch: pytest.MonkeyPatch) -> None:
    view = CellsView()
    async with WidgetApp(view).run_test(size=(5, 2)):
        view.paint(cells("abcde", "fghij"))
        assert text(view) == ["abcde", "fghij"]
        sent: list[Region] = []
        monkeypatch.setattr(view, "refresh", lambda *regions: sent.extend(regions))
        view.paint(cells("abcde", "fGHij"))
        assert text(view) == ["abcde", "fGHij"] and sent == [Region(1, 1, 2, 1)]
        view.paint(cells("abcde", "fGHij"))
        assert len(sent) == 1
