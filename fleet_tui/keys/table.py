"""Keys of every table: fleet, alarms, queue, diagnostics."""

from fleet_tui.keys.key import Key

TABLE: tuple[Key, ...] = (
    Key("row_up", ("up", "k"), "move(-1)", "Row up", pane="table"),
    Key("row_down", ("down", "j"), "move(1)", "Row down", pane="table"),
    Key("column_left", ("left", "h"), "slide(-1)", "Scroll left", pane="table"),
    Key("column_right", ("right", "l"), "slide(1)", "Scroll right", pane="table"),
    Key("page_up", ("pageup",), "move(-10)", "Ten rows up", pane="table"),
    Key("page_down", ("pagedown",), "move(10)", "Ten rows down", pane="table"),
    Key("menu", ("enter",), "menu", "Menu of the row", pane="table", hint="menu"),
)
