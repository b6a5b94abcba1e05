"""Keys of the graph editor. They work on the map, and take precedence there while a draft is edited."""

from collections.abc import Callable

from fleet_tui.actions import Actions, EditActions
from fleet_tui.keys.key import Key, Pane

FAR = 5
"""Cells of a step with Shift."""


def _edit(
    name: str, keys: tuple[str, ...], do: Callable[[EditActions], object], text: str, hint: str = ""
) -> Key[Actions]:
    return Key(
        f"edit_{name}",
        keys,
        lambda actions: do(actions.edit),
        text,
        pane=Pane.EDIT,
        hint=hint,
        in_palette=False,
        only_live=True,
    )


def _step(name: str, keys: tuple[str, ...], dx: int, dy: int) -> Key[Actions]:
    return Key(
        f"edit_{name}_far",
        keys,
        lambda actions: actions.map.pan(dx * FAR, dy * FAR),
        f"Move the cursor {FAR} cells {name}",
        pane=Pane.EDIT,
        in_palette=False,
        only_live=True,
    )


EDIT: tuple[Key[Actions], ...] = (
    Key(
        "edit",
        ("E",),
        lambda do: do.edit.start(),
        "Edit the graph of this floor, as a draft",
        sets_up=True,
        only_live=True,
    ),
    _edit("add", ("i",), lambda do: do.add_at_cursor(), "Add a vertex at the cursor", "vertex"),
    _edit("connect", ("e",), lambda do: do.connect(), "Edge from the selected vertex to the cursor", "edge"),
    _edit(
        "select", ("enter",), lambda do: do.select(), "Select; again: menu. Puts down what moves", "select"
    ),
    _edit("name", ("n",), lambda do: do.name(), "Label of the selected vertex", "name"),
    _edit("type", ("t",), lambda do: do.choose_type(), "Type of the selected vertex", "type"),
    _edit(
        "turn", ("d",), lambda do: do.turn(), "Direction of the selected edge: both ways, one, other", "turn"
    ),
    _edit("move", ("m",), lambda do: do.hold(), "Move the selected vertex: cursor, then Enter", "move"),
    _edit("remove", ("x",), lambda do: do.remove(), "Remove the selected vertex or edge", "remove"),
    _edit("undo", ("u",), lambda do: do.undo(), "Undo", "undo"),
    _edit("redo", ("ctrl+r",), lambda do: do.redo(), "Redo"),
    _edit("lint", ("!",), lambda do: do.lint(), "Check: errors, warnings, reach, longest detour", "check"),
    _edit("compare", ("D",), lambda do: do.compare(), "Differences from the live graph", "diff"),
    _edit("write", ("w",), lambda do: do.write(), "Write the draft to a file", "write"),
    _edit("send", ("W",), lambda do: do.send(), "Send the draft to the robot (asks first)", "send"),
    _edit("add_at_robot", ("I",), lambda do: do.add_at_robot(), "Add a vertex at the selected robot"),
    _edit("leave", ("escape",), lambda do: do.leave(), "Put back, deselect, or leave; the draft stays"),
    _step("left", ("shift+left", "H"), -1, 0),
    _step("right", ("shift+right", "L"), 1, 0),
    _step("up", ("shift+up", "K"), 0, -1),
    _step("down", ("shift+down", "J"), 0, 1),
)
