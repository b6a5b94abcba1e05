"""Keys for the next robot and floor that keyboards do not have behind AltGr. In recordings these step and
skip."""

from fleet_tui.actions import Actions
from fleet_tui.keys.key import Key

PLAIN: tuple[Key[Actions], ...] = (
    Key(
        "next_robot_plain",
        (".",),
        lambda do: do.view.step_robot(1),
        "Next robot",
        hint="robot",
        only_live=True,
        helps="stays",
        instead_of="next_robot",
    ),
    Key(
        "previous_robot_plain",
        (",",),
        lambda do: do.view.step_robot(-1),
        "Previous robot",
        only_live=True,
        helps="stays",
        instead_of="previous_robot",
    ),
    Key(
        "next_floor_plain",
        (">",),
        lambda do: do.view.step_floor(1),
        "Next floor",
        hint="floor",
        only_live=True,
        instead_of="next_floor",
    ),
    Key(
        "previous_floor_plain",
        ("<",),
        lambda do: do.view.step_floor(-1),
        "Previous floor",
        only_live=True,
        instead_of="previous_floor",
    ),
)
