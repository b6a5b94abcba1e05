"""Reads files that people write: limited in size, whatever the name refers to."""

import re
import tomllib
from pathlib import Path
from typing import Any

from fleet_tui.storage.handles import open_file

LARGEST = 500_000
"""Maximum bytes of a configuration or a theme."""

_MANY_PARTS = re.compile(r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){30}""")
"""Matches a deeply nested key: tomllib takes memory with the square of its parts."""


def read_text(path: Path, largest: int) -> str:
    """Return a whole UTF-8 file, without its mark. Raises OSError, and ValueError for a larger one or another
    encoding."""
    with open_file(path) as file:
        content = file.read(largest + 1)
    if len(content) > largest:
        raise ValueError(f"over {largest:,} bytes")
    return content.decode("utf-8-sig")


def read_toml(path: Path) -> dict[str, Any]:
    """Return a TOML file. Raises OSError, and ValueError or RecursionError for invalid TOML."""
    return toml(read_text(path, LARGEST))


def toml(text: str) -> dict[str, Any]:
    """Return a TOML text. Raises ValueError or RecursionError for invalid TOML."""
    if _MANY_PARTS.search(text):
        raise ValueError("a key of more than 30 parts")
    return tomllib.loads(text)
