"""Textual's bindings from the one table of keys."""

from collections.abc import Mapping

from textual.binding import Binding, BindingType
from textual.keys import _character_to_key

from fleet_tui.keys import KEYS

# What opens something to type in comes before all else: the next key, which may already be on its
# way, belongs there. What it is opened for must not come after it.
OPENING = frozenset({"order", "help", "palette", "audit", "diagnostics", "filter", "go_to_time"})
SELECTING = frozenset(key.id for key in KEYS if key.action.startswith(("step_", "robot(")))
EAGER = OPENING | SELECTING
OPENING_ACTIONS, SELECTING_ACTIONS = (
    frozenset(key.action.partition("(")[0] for key in KEYS if key.id in ids) for ids in (OPENING, SELECTING)
)


def bindings(pane: str) -> list[BindingType]:
    """The bindings that work in a pane."""
    return [
        Binding(
            ",".join(map(textual_key, key.keys)) or f"no_key_for_{key.id}",
            key.action,
            key.text,
            show=False,
            id=key.id,
            priority=pane == "anywhere" or key.id in EAGER,
        )
        for key in KEYS
        if key.pane == pane
    ]


def textual_key(key: str) -> str:
    """A key of the config as Textual calls it."""
    *modifiers, last = key.split("+") if len(key) > 1 else [key]
    return "+".join([*modifiers, _character_to_key(last) if len(last) == 1 else last])


def textual_keymap(keys: Mapping[str, tuple[str, ...]]) -> dict[str, str]:
    """The chosen keys of each id, as Textual's keymap wants them."""
    return {id_: ",".join(map(textual_key, chosen)) or f"no_key_for_{id_}" for id_, chosen in keys.items()}
