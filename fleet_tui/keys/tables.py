"""Keys of the tables that work from every pane: without a focused table they are the fleet's."""

from fleet_tui.keys.key import Key
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
