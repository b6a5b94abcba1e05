"""Calls that the keys make on the actions of the console, by name."""

from collections.abc import Iterable, Iterator
from typing import Any

from fleet_tui.keys.key import Key


class Calls:
    """Any actions: remembers each call with its full name and arguments, and plays as a player does."""

    def __init__(self, name: str = "", made: list[str] | None = None) -> None:
        self._name, self.made = name, [] if made is None else made

    def __getattr__(self, name: str) -> "Calls":
        return Calls(f"{self._name}.{name}".lstrip("."), self.made)

    def __call__(self, *arguments: Any) -> None:
        if self._name == "play":
            arguments[0](Calls("player", self.made))
        else:
            self.made.append(f"{self._name}({', '.join(map(str, arguments))})")


def calls(keys: Iterable[Key[Any]]) -> dict[str, str]:
    """The action of each key, by its id: one call."""
    return dict(_calls(keys))


def _calls(keys: Iterable[Key[Any]]) -> Iterator[tuple[str, str]]:
    for key in keys:
        actions = Calls()
        key.action(actions)
        (call,) = actions.made
        yield key.id, call
