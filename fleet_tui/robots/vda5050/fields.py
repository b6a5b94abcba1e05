"""Fields of messages, read one by one: a wrong one is named and left out, unknown ones are ignored.

Nothing is checked against the published schemas: those of 2.0 (state), 2.1 (state) and 3.0 (order,
visualization) are wrong themselves, and vehicles mix the versions.
"""

import json
import math
from collections.abc import Callable, Iterator
from typing import Any

import msgspec

from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_NAME, truncate

LARGEST = 4 * 2**20
"""Maximum bytes of a message: more is no state of a vehicle."""


class Fields:
    """An object of a message. `faults` lists the fields that could not be used."""

    def __init__(self, values: dict[str, Any], faults: list[str], path: str = "") -> None:
        self._values = values
        self.faults = faults
        self._path = path

    @classmethod
    def of(cls, payload: bytes) -> "Fields":
        """Decode a message. Raises WireError for one that is no JSON object."""
        if len(payload) > LARGEST:
            raise WireError(f"message of {len(payload):,} bytes")
        try:
            values = _decoded(payload)
        except (ValueError, RecursionError) as problem:
            raise WireError(f"no JSON: {problem}") from None
        if not isinstance(values, dict):
            raise WireError("no JSON object")
        return cls(values, [])

    def _find(self, names: tuple[str, ...]) -> tuple[str, Any]:
        """Return the first of several names that has a value, and the value: versions name it differently."""
        for name in names:
            value = self._values.get(name)
            if value is not None:
                return name, value
        return names[0], None

    def raw(self, name: str) -> Any:
        """Return a value as it is, to be compared."""
        return self._values.get(name)

    def _checked(self, names: tuple[str, ...], is_good: Callable[[Any], bool], what: str) -> Any:
        name, value = self._find(names)
        if value is None or is_good(value):
            return value
        self.faults.append(
            truncate(
                Message(
                    "{path}{name} is {given}, not {expected}",
                    path=self._path,
                    name=name,
                    given=f"{value!r}",
                    expected=what,
                ),
                LONGEST_NAME,
            )
        )
        return None

    def number(self, *names: str) -> float | None:
        found = self._checked(names, _is_number, "a number")
        return None if found is None else float(found)

    def flag(self, *names: str) -> bool | None:
        """Return a truth value."""
        found: bool | None = self._checked(names, _is_flag, "true or false")
        return found

    def text(self, *names: str, longest: int = LONGEST_NAME) -> str:
        """Return a text, empty without one."""
        return truncate(self._checked(names, _is_text, "text") or "", longest)

    def word(self, *names: str) -> str:
        """Return a word of a fixed set, in the spelling of 2.0: versions differ in case and underscores."""
        return self.text(*names).upper().replace("_", "")

    def id(self, *names: str) -> str:
        """Return a text, or a number that was written in its place."""
        found = self._checked(names, lambda value: isinstance(value, str) or _is_number(value), "an id")
        return truncate("" if found is None else str(found), LONGEST_NAME)

    def part(self, *names: str) -> "Fields | None":
        """Return an object within this one."""
        name, _ = self._find(names)
        found = self._checked(names, _is_object, "an object")
        return None if found is None else Fields(found, self.faults, f"{self._path}{name}.")

    def parts(self, most: int, *names: str) -> "list[Fields] | None":
        """Return the objects of a list, at most so many, None without a list."""
        name, _ = self._find(names)
        found = self._checked(names, _is_list, "a list")
        return None if found is None else list(self._objects(found[:most], name))

    def _objects(self, found: list[Any], name: str) -> Iterator["Fields"]:
        for n, one in enumerate(found):
            if isinstance(one, dict):
                yield Fields(one, self.faults, f"{self._path}{name}[{n}].")
            else:
                self.faults.append(
                    Message("{path}{name}[{n}] is not an object", path=self._path, name=name, n=n)
                )

    def shown(self) -> Iterator[tuple[str, str]]:
        """Return the simple values of this object by name, as texts."""
        for name, value in self._values.items():
            if isinstance(value, str | int | float) and not isinstance(value, bool):
                yield truncate(name, LONGEST_NAME), truncate(str(value), LONGEST_NAME)


def _decoded(payload: bytes) -> Any:
    """Decode JSON, with NaN and Infinity that some libraries write for numbers, in Latin-1 where it is not
    UTF-8, after a byte order mark, and up to the NUL at the end of a text of C. Raises ValueError or
    RecursionError."""
    try:
        return msgspec.json.decode(payload)
    except (msgspec.DecodeError, UnicodeDecodeError):
        payload = payload.rstrip(b"\0")
        try:
            text = payload.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = payload.decode("latin-1")
        found = json.loads(text)
        msgspec.json.encode(found)  # raises for half a surrogate pair, which no file or screen can hold
        return found


def _is_flag(value: object) -> bool:
    return isinstance(value, bool)


def _is_text(value: object) -> bool:
    return isinstance(value, str)


def _is_object(value: object) -> bool:
    return isinstance(value, dict)


def _is_list(value: object) -> bool:
    return isinstance(value, list)


def _is_number(value: object) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) < 1e15 and math.isfinite(value)
