"""Keys of every pane of rows: fleet, alarms, queue, diagnostics."""

from fleet_tui.actions.panes import RowActions
from fleet_tui.keys.key import Key, Pane

ROWS: tuple[Key[RowActions], ...] = (
    Key("row_up", ("up", "k"), lambda rows: rows.move(-1), "Move up one row", pane=Pane.ROWS),
    Key("row_down", ("down", "j"), lambda rows: rows.move(1), "Move down one row", pane=Pane.ROWS),
    Key("column_left", ("left", "h"), lambda rows: rows.slide(-1), "Scroll left", pane=Pane.ROWS),
    Key("column_right", ("right", "l"), lambda rows: rows.slide(1), "Scroll right", pane=Pane.ROWS),
    Key("page_up", ("pageup",), lambda rows: rows.move(-10), "Move up ten rows", pane=Pane.ROWS),
    Key("page_down", ("pagedown",), lambda rows: rows.move(10), "Move down ten rows", pane=Pane.ROWS),
    Key(
        "menu",
        ("enter",),
        lambda rows: rows.open_menu(),
        "Open the row menu",
        pane=Pane.ROWS,
        hint="menu",
    ),
)
