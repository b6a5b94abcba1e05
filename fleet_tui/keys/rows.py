"""Keys of every pane of rows: fleet, alarms, queue, diagnostics."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import Message

ROWS: tuple[Key, ...] = (
    Key("row_up", ("up", "k"), Message("Move up one row"), pane=Pane.ROWS),
    Key("row_down", ("down", "j"), Message("Move down one row"), pane=Pane.ROWS),
    Key("column_left", ("left", "h"), Message("Scroll left"), pane=Pane.ROWS),
    Key("column_right", ("right", "l"), Message("Scroll right"), pane=Pane.ROWS),
    Key("page_up", ("pageup",), Message("Move up ten rows"), pane=Pane.ROWS),
    Key("page_down", ("pagedown",), Message("Move down ten rows"), pane=Pane.ROWS),
    Key("menu", ("enter",), Message("Open the row menu"), pane=Pane.ROWS, hint=Message("menu")),
)
