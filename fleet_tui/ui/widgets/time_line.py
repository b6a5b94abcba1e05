"""The time line of a recording, above the hints."""

from collections.abc import Callable

from textual import events

from fleet_tui.model.replay import ReplayPosition
from fleet_tui.ui.view.lines.time import time_line
from fleet_tui.ui.widgets.messages import TimePicked
from fleet_tui.ui.widgets.runs_view import RunsView


class TimeLine(RunsView):
    """Two rows: the position, and the latest event. A click seeks."""

    DEFAULT_CSS = "TimeLine { height: 2; width: 1fr; }"

    def show(self, moment: ReplayPosition, clock: Callable[[float], str]) -> None:
        if self.size.width > 0:
            self.paint_rows(time_line(moment, clock, self.size.width))

    def on_click(self, event: events.Click) -> None:
        """Post the clicked time."""
        event.stop()
        if event.y == 0:
            self.post_message(TimePicked(event.x, self.size.width))
