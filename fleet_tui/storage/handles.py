"""Opens files of which somebody else may have made the name: none blocks, and none is a device."""

import errno
import os
import stat
from contextlib import suppress
from io import BufferedReader, FileIO
from pathlib import Path
from typing import BinaryIO

SHARED = 0o660
"""Mode of files that several users write: for the group of the folder, whatever the umask."""
_SAFE = os.O_CLOEXEC | os.O_NONBLOCK | os.O_NOCTTY


def open_file(path: Path) -> BinaryIO:
    """Open a regular file to be read. Raises OSError: a pipe or a device could block forever."""
    return BufferedReader(FileIO(path, opener=lambda name, flags: _regular(os.open(name, flags | _SAFE))))


def open_private(path: Path, flags: int) -> int:
    """Open a regular file; a new one, and its folder, for its owner alone. Raises OSError."""
    if flags & os.O_CREAT:
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    return _regular(os.open(path, flags | _SAFE, 0o600))


def open_shared(path: Path, flags: int) -> int:
    """Open a regular file, no link; a new one for the group, too. Raises OSError."""
    handle = _regular(os.open(path, flags | _SAFE | os.O_NOFOLLOW, SHARED))
    if flags & os.O_CREAT:
        share(handle, path.parent)
    return handle


def share(handle: int, folder: Path) -> None:
    """Give the group of a folder the right to write to this user's file in it. Raises OSError."""
    status = os.fstat(handle)
    if status.st_uid == os.getuid() and stat.S_IMODE(status.st_mode) != SHARED:
        with suppress(OSError):  # a folder without the setgid bit gives files the group of their maker
            os.fchown(handle, -1, folder.stat().st_gid)
        os.fchmod(handle, SHARED)


def _regular(handle: int) -> int:
    mode = os.fstat(handle).st_mode
    if not stat.S_ISREG(mode):
        os.close(handle)
        if stat.S_ISDIR(mode):
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        raise OSError(errno.EINVAL, "not a regular file")
    return handle
