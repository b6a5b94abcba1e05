"""Keys of the graph editor. They work on the map, and take precedence there while a draft is edited."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import EMPTY, Message

FAR = 5
"""Cells of a step with Shift."""


def _edit(name: str, keys: tuple[str, ...], text: Message, hint: Message = EMPTY) -> Key:
    return Key(f"edit_{name}", keys, text, pane=Pane.EDIT, hint=hint, in_palette=False, only_live=True)


def _step(name: str, keys: tuple[str, ...]) -> Key:
    return Key(
        f"edit_{name}_far",
        keys,
        Message("Move the cursor {far} cells {name}", far=FAR, name=name),
        pane=Pane.EDIT,
        in_palette=False,
        only_live=True,
    )


EDIT: tuple[Key, ...] = (
    Key("edit", ("E",), Message("Edit the graph of this floor, as a draft"), sets_up=True, only_live=True),
    _edit("add", ("i",), Message("Add a vertex at the cursor"), Message("vertex")),
    _edit("connect", ("e",), Message("Edge from the selected vertex to the cursor"), Message("edge")),
    _edit("select", ("enter",), Message("Select; again: menu. Puts down a moved vertex"), Message("select")),
    _edit("name", ("n",), Message("Label of the selected vertex"), Message("name")),
    _edit("type", ("t",), Message("Type of the selected vertex"), Message("type")),
    _edit("turn", ("d",), Message("Direction of the selected edge: both ways, one, other"), Message("turn")),
    _edit("move", ("m",), Message("Move the selected vertex: cursor, then Enter"), Message("move")),
    _edit("remove", ("x",), Message("Remove the selected vertex or edge"), Message("remove")),
    _edit("undo", ("u",), Message("Undo"), Message("undo")),
    _edit("redo", ("ctrl+r",), Message("Redo")),
    _edit("lint", ("!",), Message("Check: errors, warnings, reach, longest detour"), Message("check")),
    _edit("compare", ("D",), Message("Differences from the live graph"), Message("diff")),
    _edit("write", ("w",), Message("Write the draft to a file"), Message("write")),
    _edit("send", ("W",), Message("Send the draft to the robot (asks first)"), Message("send")),
    _edit("add_at_robot", ("I",), Message("Add a vertex at the selected robot")),
    _edit("leave", ("escape",), Message("Put back, deselect, or leave; the draft stays")),
    _step("left", ("shift+left", "H")),
    _step("right", ("shift+right", "L")),
    _step("up", ("shift+up", "K")),
    _step("down", ("shift+down", "J")),
)
