"""Keys of tables."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import Message

TABLES: tuple[Key, ...] = (
    Key(
        "filter_rows",
        ("/",),
        Message("Filter the table: words, !word, key:value"),
        hint=Message("filter"),
        of_rows=True,
    ),
    Key(
        "mark_row",
        ("space",),
        Message("Mark the row: the next command goes to all marked ones"),
        hint=Message("mark"),
        only_live=True,
        of_rows=True,
    ),
    Key(
        "sort_rows",
        ("S",),
        Message("Sort the table by its next column"),
        hint=Message("sort"),
        only_live=True,
        of_rows=True,
    ),
    Key(
        "group_rows",
        ("Z",),
        Message("Group the fleet by floor, by link, or not; Enter folds a group"),
        of_rows=True,
    ),
    Key(
        "copy_row",
        ("y",),
        Message("Copy the row, or all marked ones, to the clipboard (OSC 52)"),
        of_rows=True,
    ),
)
"""They work from every pane: without a focused table they are the fleet's."""

ROWS: tuple[Key, ...] = (
    Key("row_up", ("up", "k"), Message("Move up one row"), pane=Pane.ROWS),
    Key("row_down", ("down", "j"), Message("Move down one row"), pane=Pane.ROWS),
    Key("column_left", ("left", "h"), Message("Scroll left"), pane=Pane.ROWS),
    Key("column_right", ("right", "l"), Message("Scroll right"), pane=Pane.ROWS),
    Key("page_up", ("pageup",), Message("Move up by the rows in view"), pane=Pane.ROWS),
    Key("page_down", ("pagedown",), Message("Move down by the rows in view"), pane=Pane.ROWS),
    Key("first_row", ("home",), Message("Go to the first row"), pane=Pane.ROWS, yields=True, only_live=True),
    Key("last_row", ("end",), Message("Go to the last row"), pane=Pane.ROWS, yields=True, only_live=True),
    Key("menu", ("enter",), Message("Open the row menu"), pane=Pane.ROWS, hint=Message("menu")),
)
"""They work in every pane of rows: fleet, alarms, queue, diagnostics."""
