"""The time line of a recording: it shows the position, and a click says which cell."""

from fleet_tui.model.replay import ReplayPosition
from fleet_tui.text.language import Message
from fleet_tui.ui.widgets.messages import TimePicked
from fleet_tui.ui.widgets.time_line import TimeLine
from tests.support.widget_app import WidgetApp, text


class Picks(WidgetApp):
    """Remembers what was picked."""

    def __init__(self, line: TimeLine) -> None:
        super().__init__(line)
        self.picked: list[tuple[int, int]] = []

    def on_time_picked(self, message: TimePicked) -> None:
        self.picked.append((message.x, message.width))


async def test_a_click_is_a_cell_of_its_width() -> None:
    line = TimeLine(id="time-line")
    app = Picks(line)
    async with app.run_test(size=(60, 5)) as pilot:
        moment = ReplayPosition(
            began=0.0,
            ended=100.0,
            at=50.0,
            wall=0.0,
            speed=1.0,
            reached=None,
            paused=True,
            is_over=False,
            busy=None,
            marks=[],
            note=Message("truncated"),
            jumps=0,
        )
        line.show(moment, lambda _wall: "12:00:00")
        assert "12:00:00" in "".join(text(line)) and "truncated" in "".join(text(line))
        await pilot.click("#time-line", offset=(30, 0))
        await pilot.pause()
        assert app.picked == [(30, 60)]
