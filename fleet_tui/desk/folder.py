"""Files of a folder that others may write: no name leads elsewhere or blocks, and sizes are limited."""

import errno
import fcntl
import os
import stat
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

LOCK_WITHIN = 1.0
"""Seconds to wait for a lock that another console holds for a moment."""
SHARED = 0o660
"""Mode of the desk's files: for the group of the folder, whatever the umask."""
_SAFE = os.O_CLOEXEC | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_NOCTTY


def open_shared(path: Path, flags: int) -> int:
    """Open a regular file, no link; a new one for the group, too. Raises OSError."""
    handle = os.open(path, flags | _SAFE, SHARED)
    status = os.fstat(handle)
    if not stat.S_ISREG(status.st_mode):
        os.close(handle)
        raise OSError(errno.EINVAL, f"{path.name} is not a regular file")
    if flags & os.O_CREAT and status.st_uid == os.getuid() and stat.S_IMODE(status.st_mode) != SHARED:
        with suppress(OSError):  # a folder without the setgid bit gives files the group of their maker
            os.fchown(handle, -1, path.parent.stat().st_gid)
        os.fchmod(handle, SHARED)
    return handle


def read_small(path: Path, largest: int) -> bytes:
    """Return the content of a file. Raises OSError, also for one over `largest` bytes."""
    handle = open_shared(path, os.O_RDONLY)
    try:
        data = os.read(handle, largest + 1)
    finally:
        os.close(handle)
    if len(data) > largest:
        raise OSError(errno.EFBIG, f"{path.name} is over {largest:,} bytes")
    return data


def replace_shared(path: Path, data: bytes) -> None:
    """Replace a file: readers see the old one or the new one. Raises OSError."""
    beside = path.with_name(f".{path.name}.new")
    beside.unlink(missing_ok=True)
    handle = open_shared(beside, os.O_WRONLY | os.O_CREAT | os.O_EXCL)
    try:
        if os.write(handle, data) != len(data):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    except OSError:
        beside.unlink(missing_ok=True)
        raise
    finally:
        os.close(handle)
    beside.replace(path)


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold a lock that all consoles share. Raises OSError if another holds it for longer than a moment."""
    handle = open_shared(path, os.O_RDWR | os.O_CREAT)
    try:
        until = time.monotonic() + LOCK_WITHIN
        while not _try_lock(handle):
            if time.monotonic() > until:
                raise OSError(errno.EAGAIN, f"{path.name} is locked by another console")
            time.sleep(0.005)
        yield
    finally:
        os.close(handle)


def _try_lock(handle: int) -> bool:
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def is_held(path: Path) -> bool:
    """Tell whether a process of this machine holds the lock of a file."""
    try:
        handle = open_shared(path, os.O_RDONLY)
    except OSError:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    finally:
        os.close(handle)
    return False
