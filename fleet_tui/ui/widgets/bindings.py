"""Textual's bindings from the one table of keys."""

from collections.abc import Mapping

from textual.binding import Binding, BindingType
from textual.keys import _character_to_key

from fleet_tui.keys import KEYS, Key, Pane


def bindings(pane: Pane) -> list[BindingType]:
    return [
        Binding(
            ",".join(map(textual_key, key.keys)) or f"no_key_for_{key.id}",
            action_of(key),
            key.text,
            show=False,
            id=key.id,
            priority=pane is Pane.ANYWHERE or key.in_dialogs,
        )
        for key in KEYS
        if key.pane is pane
    ]


def overlay_bindings(own: str) -> list[BindingType]:
    """Return the bindings of the console's keys that work in an overlay: its own by id closes it, and help
    opens in its place."""
    return _rebound({own: "close", "help": "screen.key('help_anywhere')"})


def table_bindings() -> list[BindingType]:
    """Return the bindings of the console's keys of tables for an overlay over one, by the same ids."""
    actions = {"filter_rows": "filter", "sort_rows": "sort", "mark_row": "mark", "copy_row": "copy"}
    return _rebound(actions)


def _rebound(actions: Mapping[str, str]) -> list[BindingType]:
    return [
        Binding(one.key, actions[one.id or ""], show=False, id=one.id)
        for one in bindings(Pane.CONSOLE)
        if isinstance(one, Binding) and one.id in actions
    ]


def action_of(key: Key) -> str:
    """Return Textual's action string: tables and diagnostics run their own keys, the main screen the
    others."""
    widget = "" if key.pane in (Pane.ROWS, Pane.DIAGNOSTICS, Pane.HISTORY) else "screen."
    return f"{widget}key({key.id!r})"


def textual_key(key: str) -> str:
    """Return Textual's name of a key of the config."""
    *modifiers, last = key.split("+") if len(key) > 1 else [key]
    return "+".join([*modifiers, _character_to_key(last) if len(last) == 1 else last])


def textual_keymap(keys: Mapping[str, tuple[str, ...]]) -> dict[str, str]:
    """Return the chosen keys of each id, as Textual's keymap."""
    return {id_: ",".join(map(textual_key, chosen)) or f"no_key_for_{id_}" for id_, chosen in keys.items()}
