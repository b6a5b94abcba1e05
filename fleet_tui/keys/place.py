"""Keys of the choice of a pose or goal on the map. They take precedence there while one is chosen."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import EMPTY, Message

TURN = 5
FINE_TURN = 1
"""Degrees of a step."""


def _place(name: str, keys: tuple[str, ...], text: Message, hint: Message = EMPTY) -> Key:
    return Key(f"place_{name}", keys, text, pane=Pane.PLACE, hint=hint, in_palette=False, only_live=True)


PLACE: tuple[Key, ...] = (
    Key(
        "laser",
        ("u",),
        Message("Laser scan of the selected robot on or off"),
        hint=Message("laser"),
        helps="stays",
        needs="scan",
        only_live=True,
    ),
    Key(
        "path", ("U",), Message("Planned path of the selected robot on or off"), needs="path", only_live=True
    ),
    Key(
        "camera",
        ("V",),
        Message("Camera of the selected robot on or off"),
        hint=Message("camera"),
        helps="stays",
        needs="camera",
        only_live=True,
    ),
    Key(
        "pose",
        ("I",),
        Message("Set the robot's pose: cursor and heading on the map"),
        needs="pose",
        commands=True,
        sets_up=True,
        only_live=True,
        helps="leaves",
    ),
    Key(
        "goal",
        ("G",),
        Message("Send the robot to a place with a heading"),
        needs="goal",
        commands=True,
        only_live=True,
    ),
    Key("mapping", ("M",), Message("Mapping: on, off, the live map, save it"), only_live=True),
    _place("send", ("enter",), Message("Ask, then send the pose or goal"), Message("send")),
    _place(
        "left",
        ("h",),
        Message("Turn the heading {degrees} degrees to the left", degrees=TURN),
        Message("turn left"),
    ),
    _place(
        "right",
        ("l",),
        Message("Turn the heading {degrees} degrees to the right", degrees=TURN),
        Message("right"),
    ),
    _place("fine_left", ("H",), Message("Turn {degrees} degree to the left", degrees=FINE_TURN)),
    _place("fine_right", ("L",), Message("Turn {degrees} degree to the right", degrees=FINE_TURN)),
    _place("snap", ("s",), Message("Snap the pose to the best fit of the scan nearby"), Message("best fit")),
    _place("leave", ("escape",), Message("Leave without sending"), Message("back")),
)
