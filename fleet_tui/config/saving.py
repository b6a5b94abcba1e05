"""Writes a configuration to a file of mode 600: the names in it may be confidential."""

from pathlib import Path
from typing import Protocol

from fleet_tui.config.as_toml import as_toml
from fleet_tui.config.schema import Config, expanded
from fleet_tui.config.trust import written_file
from fleet_tui.errors import FleetError
from fleet_tui.storage.whole_file import write_whole

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

    def write(self, name: str) -> Path:
        """Write it, overwriting any file, and return the path. Raises FleetError."""
        if self._config.withheld:
            raise FleetError(f"not saved, parts of it are off: {self._config.withheld[0]}")
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
            raise FleetError(f"{name}: is a folder: name a file")
        write_whole(path, text.encode())
    except OSError as problem:
        raise FleetError(f"{name}: {problem.strerror}") from None
    return path
