"""An append-only file of lines that several processes may write to, rotated by size, mode 600."""

import errno
import os
import stat
from pathlib import Path

from fleet_tui.storage.handles import open_private
from fleet_tui.storage.lock import lock


def append_line(handle: int, line: bytes) -> None:
    """Append a line, which ends with a newline, in one write; one that a killed process left open ends first.
    Raises OSError if it could not be written whole."""
    size = os.fstat(handle).st_size
    if size and os.pread(handle, 1, size - 1) != b"\n":
        line = b"\n" + line
    if os.write(handle, line) < len(line):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def part(path: Path, number: int) -> Path:
    """Return the file itself (0), or an older one: the higher the number, the older."""
    return path.with_name(f"{path.name}.{number}") if number else path


class LineFile:
    """Appends each line in one write, so that lines of several processes never mix and a kill leaves at most
    one torn line: the last. `max_bytes` is the maximum size of a file, `kept` the number of files including
    the current one.

    Nothing is synced to the disk: a killed process loses nothing by that, and a command must not wait for a
    disk. Only a power cut may cost the last seconds.
    """

    def __init__(self, path: Path, max_bytes: int, kept: int) -> None:
        self.path = path
        self.warning = ""
        self._max_bytes = max_bytes
        self._kept = kept
        self._fd: int | None = None

    def append(self, line: bytes) -> None:
        """Write a line, which ends with a newline. Raises OSError if it could not be written whole."""
        fd = self._current()
        size = os.fstat(fd).st_size
        if size and size + len(line) > self._max_bytes:
            fd = self._rotated(fd)
        append_line(fd, line)

    def close(self) -> None:
        """Close the file; the next line opens it again."""
        fd, self._fd = self._fd, None
        if fd is not None:
            os.close(fd)

    def _current(self) -> int:
        """Return the file that has the name now: another process may have rotated it, a person removed it."""
        if self._fd is None or not self._has_the_name(self._fd):
            self.close()
            self._fd = open_private(self.path, os.O_RDWR | os.O_APPEND | os.O_CREAT)
            self._keep_private(self._fd)
        return self._fd

    def _has_the_name(self, fd: int) -> bool:
        try:
            return os.path.samestat(os.fstat(fd), os.stat(self.path))  # noqa: PTH116  # a fifth of Path.stat's time
        except FileNotFoundError:
            return False

    def _keep_private(self, fd: int) -> None:
        mode = stat.S_IMODE(os.fstat(fd).st_mode)
        self.warning = ""
        if mode != 0o600:
            try:
                os.fchmod(fd, 0o600)
            except OSError:
                self.warning = f"{self.path.name} has mode {mode:03o} instead of 600"

    def _rotated(self, fd: int) -> int:
        """Return the file to write to after this one was full. It keeps growing if it can't be renamed: a
        record matters more than the size."""
        try:
            # The lock is on the full file itself, and never waited for: its holder may be stopped.
            if not lock(fd):
                return fd
            if self._has_the_name(fd):
                self._shift()
        except OSError:
            return fd
        self.close()
        return self._current()

    def _shift(self) -> None:
        """Each file takes the next number, up to the first that is free: a kill in the middle of this
        leaves a gap, and costs no file."""
        last = self._kept - 1
        free = next((n for n in range(1, last) if not part(self.path, n).exists()), last)
        for number in range(free, 0, -1):
            part(self.path, number - 1).replace(part(self.path, number))
