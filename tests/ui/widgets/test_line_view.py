"""One line: something at the left, something at the right, and which gives way."""

import pytest

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run
from fleet_tui.ui.widgets.line_view import LineView
from tests.support.widget_app import WidgetApp, text

TEXT = StyleRole.TEXT


@pytest.mark.parametrize(
    ("left", "right", "keep_right", "line"),
    [
        ("left", "right", False, "left           right"),
        ("left", "", False, "left                "),
        ("a" * 18, "right", False, "a" * 18 + "  "),
        ("a" * 30, "right", True, "a" * 14 + " right"),
    ],
)
async def test_what_does_not_fit_gives_way(left: str, right: str, keep_right: bool, line: str) -> None:
    view = LineView(id="line", keep_right=keep_right)
    runs: list[Run] = [(right, TEXT)] if right else []
    async with WidgetApp(view).run_test(size=(20, 3)):
        view.show([(left, TEXT)], runs)
        shown = text(view)[0].replace("…", "a")
    assert shown.strip() == line.strip() and len(shown) <= 20
