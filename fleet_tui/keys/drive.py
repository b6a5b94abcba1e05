"""Keys of driving by hand. They work on the map, and take precedence there while a robot is driven."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import EMPTY, Message

PASSES = frozenset(
    {
        "pause_all",
        "pause_all_anywhere",
        "suspend",
        "repaint",
        "palette",
        "help",
        "help_anywhere",
        "next_pane",
        "previous_pane",
    }
)
"""The ids of the other keys that keep their meaning. All but one of them end the drive."""

WHILE_HELD = {
    "drive_ahead": "w",
    "drive_back": "s",
    "drive_left": "a",
    "drive_right": "d",
    "drive_sideways_left": "q",
    "drive_sideways_right": "e",
}
"""The ids of the keys that drive while held, and their directions."""


def _drive(name: str, keys: tuple[str, ...], text: Message, hint: Message = EMPTY) -> Key:
    return Key(f"drive_{name}", keys, text, pane=Pane.DRIVE, hint=hint, in_palette=False, only_live=True)


DRIVE: tuple[Key, ...] = (
    Key(
        "drive",
        ("T",),
        Message("Drive the selected robot by hand. Not an emergency stop"),
        needs="drive",
        commands=True,
        sets_up=True,
        only_live=True,
    ),
    _drive("ahead", ("w",), Message("Ahead, while held"), Message("ahead")),
    _drive("back", ("s",), Message("Back, while held"), Message("back")),
    _drive("left", ("a",), Message("Turn left, while held"), Message("left")),
    _drive("right", ("d",), Message("Turn right, while held"), Message("right")),
    _drive("leave", ("escape",), Message("Stop and leave; any other key stops"), Message("leave")),
    _drive("sideways_left", ("q",), Message("Sideways to the left, if it can")),
    _drive("sideways_right", ("e",), Message("Sideways to the right, if it can")),
    _drive("faster", ("+",), Message("Faster, up to the cap"), Message("faster")),
    _drive("slower", ("-",), Message("Slower"), Message("slower")),
)
