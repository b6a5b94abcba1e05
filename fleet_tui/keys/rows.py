"""Keys of every pane of rows: fleet, alarms, queue, diagnostics."""

from fleet_tui.actions.panes import RowActions
from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import Message

ROWS: tuple[Key[RowActions], ...] = (
    Key("row_up", ("up", "k"), lambda rows: rows.move(-1), Message("Move up one row"), pane=Pane.ROWS),
    Key("row_down", ("down", "j"), lambda rows: rows.move(1), Message("Move down one row"), pane=Pane.ROWS),
    Key("column_left", ("left", "h"), lambda rows: rows.slide(-1), Message("Scroll left"), pane=Pane.ROWS),
    Key("column_right", ("right", "l"), lambda rows: rows.slide(1), Message("Scroll right"), pane=Pane.ROWS),
    Key("page_up", ("pageup",), lambda rows: rows.move(-10), Message("Move up ten rows"), pane=Pane.ROWS),
    Key(
        "page_down", ("pagedown",), lambda rows: rows.move(10), Message("Move down ten rows"), pane=Pane.ROWS
    ),
    Key(
        "menu",
        ("enter",),
        lambda rows: rows.open_menu(),
        Message("Open the row menu"),
        pane=Pane.ROWS,
        hint=Message("menu"),
    ),
)
