"""Reads files that people write: limited in size, whatever the name refers to."""

import errno
import os
import re
import stat
import tomllib
from io import BufferedReader, FileIO
from pathlib import Path
from typing import Any, BinaryIO

LARGEST = 500_000
"""Maximum bytes of a configuration or a theme."""

_MANY_PARTS = re.compile(r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){30}""")
"""Matches a deeply nested key: tomllib takes memory with the square of its parts."""


def _without_waiting(path: str, flags: int) -> int:
    return os.open(path, flags | os.O_NONBLOCK | os.O_NOCTTY)


def open_file(path: Path) -> BinaryIO:
    """Open a regular file to be read. Raises OSError: a pipe or a device could block forever."""
    file = FileIO(path, opener=_without_waiting)
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        file.close()
        raise OSError(errno.EINVAL, "not a regular file")
    return BufferedReader(file)


def read_text(path: Path, largest: int) -> str:
    """Return a whole UTF-8 file. Raises OSError, and ValueError for a larger one or another encoding."""
    with open_file(path) as file:
        content = file.read(largest + 1)
    if len(content) > largest:
        raise ValueError(f"over {largest:,} bytes")
    return content.decode()


def read_toml(path: Path) -> dict[str, Any]:
    """Return a TOML file. Raises OSError, and ValueError or RecursionError for invalid TOML."""
    return toml(read_text(path, LARGEST))


def toml(text: str) -> dict[str, Any]:
    """Return a TOML text. Raises ValueError or RecursionError for invalid TOML."""
    if _MANY_PARTS.search(text):
        raise ValueError("a key of more than 30 parts")
    return tomllib.loads(text)
