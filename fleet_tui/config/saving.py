"""Writes a configuration to a file of mode 600: the names in it may be confidential."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

import msgspec
from msgspec.structs import replace

from fleet_tui.config.schema import NOT_IN_FILE, Config, expanded
from fleet_tui.config.trust import written_file
from fleet_tui.storage.whole_file import write_whole
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message


def _value(value: object) -> str:
    """Return a value on one line. JSON's strings, numbers and lists are valid TOML."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(_lines(value)) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_value, value)) + "]"
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(name: str) -> str:
    return _value(name)


def _lines(table: Mapping[str, object]) -> list[str]:
    return [f"{_key(key)} = {_value(value)}" for key, value in table.items() if value is not None]


def as_toml(config: Config) -> str:
    """Return the text of a file that parses to this configuration."""
    text = []
    for name, part in msgspec.to_builtins(config, enc_hook=str).items():
        if name in NOT_IN_FILE:
            continue
        head, tables = (f"[[{name}]]", part) if isinstance(part, list) else (f"[{name}]", [part])
        for table in tables:
            text += [head, *_lines(table), ""]
    return "\n".join(text)


USUAL = "config.toml"


class Source(Protocol):
    """The source of a configuration without a file."""

    @property
    def text(self) -> str:
        """Return the text that it was read from."""


class Saving:
    """The configuration of a console, to be written to a file."""

    def __init__(self, config: Config, source: Source | None = None) -> None:
        self._config = config
        self._source = source
        self.path = "" if source is not None else str(config.path)
        """The file in which it is, empty where it is in none."""

    def extend(self, config: Config) -> None:
        """Write the robots and floors of this configuration instead, and no choice of this console."""
        self._config = replace(self._config, robots=config.robots, floors=config.floors)
        self._source = None

    def write(self, name: str) -> Path:
        """Write it, overwriting any file, and return the path. Raises FleetError."""
        if self._config.withheld:
            raise FleetError(
                Message("not saved, parts of it are off: {withheld}", withheld=self._config.withheld[0])
            )
        # In a copy elsewhere the names of files must still be valid.
        text = as_toml(self._config.whole()) if self._source is None else self._source.text
        path = write_config(text, name)
        self.path = self.path or str(path)
        return path


def write_config(text: str, name: str) -> Path:
    """Write a file of mode 600, whole or not at all, and return its path. Raises FleetError."""
    path = expanded(name)
    try:
        path = written_file(path)
        if path.is_dir():
            raise FleetError(Message("{name}: is a folder: name a file", name=name))
        write_whole(path, text.encode())
    except OSError as problem:
        raise FleetError(Message("{name}: {strerror}", name=name, strerror=problem.strerror)) from None
    return path
