"""The operator's key assignments, checked before the screen opens, since Textual reports no errors."""

from collections.abc import Iterable, Mapping

from fleet_tui.keys import BY_ID, KEYS, Key, Pane
from fleet_tui.text.errors import did_you_mean

# Textual's names of non-printing keys.
_NAMED = frozenset(
    ["enter", "tab", "escape", "space", "backspace", "delete", "insert", "home", "end"]
    + ["pageup", "pagedown", "up", "down", "left", "right"]
    + [f"f{n}" for n in range(1, 25)]
)
# Ctrl-C never commands a robot; a terminal sends these as other keys.
_FORBIDDEN = {
    "ctrl+c": "Ctrl-C is reserved",
    "ctrl+i": "a terminal sends it as tab",
    "ctrl+m": "a terminal sends it as enter",
    "ctrl+[": "a terminal sends it as escape",
}


def _problem_of_key(key: str) -> str | None:
    """Return the reason that a key can't be bound, None if it can."""
    if key in _FORBIDDEN:
        return _FORBIDDEN[key]
    *modifiers, last = key.split("+") if len(key) > 1 else [key]
    known = (len(last) == 1 and last.isprintable() and not last.isspace()) or last in _NAMED
    if not known:
        return f"unknown key{did_you_mean(last, _NAMED)}"
    if len(last) == 1 and "shift" in modifiers:
        return "use the shifted character itself"
    if len(last) == 1 and last.isupper() and "ctrl" in modifiers:
        return f"a terminal sends it as {key.lower()}"
    wrong = [name for name in modifiers if name not in ("ctrl", "shift", "alt")]
    return f"unknown modifier {wrong[0]}, use ctrl, shift or alt" if wrong else None


def _types_nothing(key: str) -> bool:
    """Tell whether a key has no use in a text field: a space or an arrow would be taken from it."""
    *modifiers, last = key.split("+")
    return "ctrl" in modifiers or "alt" in modifiers or (len(last) > 1 and last[1:].isdigit())


def _same_place(one: Key, other: Key) -> bool:
    """Tell whether two panes' keys can be pressed at the same moment."""
    panes = {one.pane, other.pane}
    if Pane.RECORDING in panes and (one.only_live or other.only_live):
        return False
    if one.in_dialogs or other.in_dialogs:
        return True
    if any(pane.is_mode for pane in panes):
        # While the map is in a mode its keys take precedence.
        return len(panes) == 1 or Pane.ANYWHERE in panes
    for pane in (Pane.DIAGNOSTICS, Pane.HISTORY):
        if pane in panes:
            # The console's keys don't work in there; it is made of one table.
            return panes <= {pane, Pane.ROWS, Pane.ANYWHERE}
    return len(panes) == 1 or any(pane.is_everywhere for pane in panes)


def keymap(changes: Mapping[str, str]) -> tuple[dict[str, tuple[str, ...]], list[str]]:
    """Return the keys of every id after the config's `changes` (id = "key" or "key,key"), and one line for
    each problem: unknown id, impossible key, two ids on one key."""
    problems = []
    chosen = {key.id: key.keys for key in KEYS}
    for id_, text in changes.items():
        if id_ not in BY_ID:
            problems.append(f"keys.{id_}: unknown key id{did_you_mean(id_, BY_ID)}")
            continue
        keys = ("," if text == "," else part.strip() for part in ([text] if text == "," else text.split(",")))
        chosen[id_] = tuple(keys)
        for key in chosen[id_]:
            wrong = _problem_of_key(key)
            if BY_ID[id_].pane is Pane.ANYWHERE and not _types_nothing(key):
                wrong = "also works while typing: use a function key or a ctrl key"
            if wrong:
                problems.append(f"keys.{id_}: {key!r}: {wrong}")
    chosen |= _yielded(chosen, changes)
    problems.extend(_clashes(chosen))
    return chosen, problems


def _yielded(chosen: Mapping[str, tuple[str, ...]], changes: Mapping[str, str]) -> dict[str, tuple[str, ...]]:
    """Return the keys of recordings and tables, and second keys, without those that the config assigns
    otherwise: these take precedence."""
    given = {key for id_ in changes if id_ in chosen for key in chosen[id_]}
    return {
        key.id: tuple(one for one in key.keys if one not in given)
        for key in KEYS
        if (key.pane is Pane.RECORDING or key.of_rows or key.instead_of or key.yields)
        and key.id not in changes
    }


def _clashes(chosen: Mapping[str, Iterable[str]]) -> list[str]:
    taken: dict[str, list[Key]] = {}
    problems = []
    for id_, keys in chosen.items():
        this = BY_ID[id_]
        for key in keys:
            for other in taken.setdefault(key, []):
                if _same_place(this, other):
                    problems.append(f"keys.{id_}: {key!r} is already used by {other.id}: change one of them")
            taken[key].append(this)
    return problems
