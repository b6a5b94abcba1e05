"""Dialogs are all in one box, and where the style sheet has them without one."""

from textual.app import App, ComposeResult
from textual.containers import Vertical
from textual.geometry import Region

from fleet_tui.ui.view.layout import DialogBox
from fleet_tui.ui.widgets.dialog_place import DialogPlace, lines_below


class Dialogs(App[None]):
    """Two dialogs, the second in a column of its own."""

    CSS = """
    #one { dock: bottom; height: 100%; width: 60%; margin: 0 0 2 0; }
    #column { dock: right; height: 100%; width: 50%; }
    """

    def compose(self) -> ComposeResult:
        yield Vertical(id="one")
        yield Vertical(id="column")


async def test_dialogs_are_in_their_box_at_the_bottom_and_one_at_the_side_keeps_its_column() -> None:
    app = Dialogs()
    async with app.run_test(size=(80, 24)) as pilot:
        one, column = app.query_one("#one"), app.query_one("#column")
        place = DialogPlace(one, column)
        place.move_to(DialogBox(38, 42, 9))
        await pilot.pause()
        assert one.region == Region(38, 13, 42, 9) and column.region == Region(40, 0, 40, 24)
        assert lines_below(one) == 1, "it is beside the map"
        place.move_to(None)
        await pilot.pause()
        assert (one.region.x, one.region.width, one.region.bottom) == (0, 48, 22)
        assert lines_below(one) == one.region.height
