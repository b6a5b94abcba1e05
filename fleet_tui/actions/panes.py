"""Actions of the panes and of a recording's player, as types."""

from typing import Protocol


class MapActions(Protocol):
    def zoom_in(self) -> None: ...

    def zoom_out(self) -> None: ...

    def fit(self) -> None:
        """Show the whole floor."""

    def zoom_about(self) -> None:
        """Zoom about the selected robot, or about the centre."""

    def follow(self) -> None:
        """Follow the selected robot, or stop following."""

    def centre(self) -> None:
        """Centre on the selected robot, once."""

    def edges(self) -> None:
        """Show or hide the edges."""

    def labels(self) -> None:
        """Show or hide the labels."""

    def trails(self) -> None:
        """Show or hide the trails."""

    def drawing(self) -> None:
        """Go to the next drawing style."""

    def cursor(self) -> None:
        """Turn the cursor on or off."""

    def next_vertex(self, step: int) -> None:
        """Put the cursor on the next (1) or previous (-1) labelled vertex."""

    def pan(self, dx: int, dy: int) -> None:
        """Move by steps to the right and down."""

    def pick(self) -> None:
        """Pick the object under the cursor."""


class RowActions(Protocol):
    """Actions on the rows of a table."""

    def move(self, step: int) -> None:
        """Move the cursor by rows."""

    def slide(self, step: int) -> None:
        """Slide long rows to the left or right."""

    def open_menu(self) -> None:
        """Open the menu of the cursor's row."""


class DiagnosticsActions(Protocol):
    def page(self, number: int) -> None: ...

    def step_page(self, step: int) -> None:
        """Show the next (1) or previous (-1) page."""

    def filter(self) -> None:
        """Filter the rows by typed text."""

    def freeze(self) -> None:
        """Freeze the shown data, or resume."""

    def copy(self) -> None:
        """Copy the message or the row to the terminal's clipboard."""

    def next_level(self) -> None:
        """Show fewer levels of the robots' log, or all again."""

    def show_bad(self) -> None:
        """Show the last bad message of the topic, or the newest one."""

    def leave(self) -> None:
        """Go one level back."""


class HistoryActions(Protocol):
    def page(self, number: int) -> None: ...

    def step_page(self, step: int) -> None:
        """Show the next (1) or previous (-1) page."""

    def filter(self) -> None:
        """Open the field for the filter."""

    def shift(self, step: int) -> None:
        """Show a later (1) or an earlier (-1) time."""

    def stretch(self, step: int) -> None:
        """Show a longer (1) or a shorter (-1) time."""

    def next_floor(self) -> None:
        """Show the places of the next floor."""

    def replay(self) -> None:
        """Open the recording at the time of the marked row."""

    def leave(self) -> None:
        """Go back one level."""


class PlayerActions(Protocol):
    """Actions of the player of a recording."""

    def toggle(self) -> None:
        """Play, or stop."""

    def skip(self, seconds: float) -> None:
        """Skip forward or back by seconds."""

    def to_mark(self, step: int) -> str:
        """Go to the next (1) or previous (-1) mark. Returns a notice if no such mark exists."""

    def step(self, ticks: int) -> None:
        """Move one tick forward (1) or back (-1), and stop there."""

    def step_record(self, records: int) -> None:
        """Move one record forward (1) or back (-1), and stop there."""

    def change_speed(self, step: int) -> None:
        """Play faster (1), slower (-1) or at the original speed (0)."""

    def to_end(self, step: int) -> None:
        """Go to the beginning (-1) or the end (1)."""
