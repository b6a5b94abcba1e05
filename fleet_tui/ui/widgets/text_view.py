"""Lines of text, scrolled."""

from collections.abc import Callable, Sequence

from textual import events, on

from fleet_tui.text.language import tr
from fleet_tui.ui.view.tables.table import Run, cut
from fleet_tui.ui.widgets.runs_view import RunsView


class TextView(RunsView):
    """Shows lines made for its width. It has no focus: the keys that scroll it are those of a field."""

    def __init__(self, *, id: str, moved: Callable[[str], None]) -> None:
        """`moved` is called with the position, empty if all lines are visible."""
        super().__init__(id=id)
        self._moved = moved
        self._lines: Callable[[int], Sequence[Sequence[Run]]] = lambda width: ()
        self._top = 0

    def show(self, lines: Callable[[int], Sequence[Sequence[Run]]]) -> None:
        """Show the first of these lines."""
        self._lines = lines
        self._top = 0
        self.draw()

    def move(self, step: int) -> None:
        """Scroll up or down."""
        self._top += step
        self.draw()

    @property
    def page(self) -> int:
        return self.size.height

    def draw(self) -> None:
        """Paint the visible lines."""
        width, height = self.size
        if width < 1 or height < 1:
            return
        lines = self._lines(width)
        self._top = max(0, min(self._top, len(lines) - height))
        seen = [cut(line, width) for line in lines[self._top : self._top + height]]
        self.paint_rows([*seen, *[cut((), width)] * (height - len(seen))])
        last = self._top + len(seen)
        is_whole = len(lines) <= height
        self._moved(
            ""
            if is_whole
            else tr("{first}-{last} of {lines}, PgUp PgDn", first=self._top + 1, last=last, lines=len(lines))
        )

    @on(events.MouseScrollUp)
    @on(events.MouseScrollDown)
    def scroll_by_wheel(self, event: events.MouseScrollUp | events.MouseScrollDown) -> None:
        """Scroll by three lines."""
        event.stop()
        self.move(3 if isinstance(event, events.MouseScrollDown) else -3)

    def on_resize(self) -> None:
        """Paint for the new size."""
        self.draw()
