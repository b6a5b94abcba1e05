"""Keys of every table: fleet, alarms, queue, diagnostics."""

from fleet_tui.actions import RowActions
from fleet_tui.keys.key import Key, Pane

TABLE: tuple[Key[RowActions], ...] = (
    Key("row_up", ("up", "k"), lambda rows: rows.move(-1), "Row up", pane=Pane.TABLE),
    Key("row_down", ("down", "j"), lambda rows: rows.move(1), "Row down", pane=Pane.TABLE),
    Key("column_left", ("left", "h"), lambda rows: rows.slide(-1), "Scroll left", pane=Pane.TABLE),
    Key("column_right", ("right", "l"), lambda rows: rows.slide(1), "Scroll right", pane=Pane.TABLE),
    Key("page_up", ("pageup",), lambda rows: rows.move(-10), "Ten rows up", pane=Pane.TABLE),
    Key("page_down", ("pagedown",), lambda rows: rows.move(10), "Ten rows down", pane=Pane.TABLE),
    Key("menu", ("enter",), lambda rows: rows.open_menu(), "Menu of the row", pane=Pane.TABLE, hint="menu"),
)
