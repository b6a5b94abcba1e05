"""The owner of robots: one routine at a time gives orders to a robot, whatever process it runs in."""

import fcntl
import hashlib
import os
from collections.abc import Mapping
from pathlib import Path

from fleet_tui.errors import RoutineError
from fleet_tui.text.sanitize import sanitize

LONGEST = 200
"""Bytes of the owner in a lock file."""


class RobotLocks:
    """Locks for robots, held until `release` or the end of the process. `robots`: the URL of each one's
    bridge: robots of two sites may share a name."""

    def __init__(self, folder: Path, robots: Mapping[str, str], owner: str) -> None:
        self._paths = {name: folder / f"{_key(name, url)}.lock" for name, url in robots.items()}
        self._owner = owner
        self._handles = list[int]()

    def claim(self) -> None:
        """Become the owner. Raises RoutineError with the present one."""
        try:
            for robot, path in self._paths.items():
                self._claim(robot, path)
        except RoutineError:
            self.release()
            raise

    def _claim(self, robot: str, path: Path) -> None:
        try:
            path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        except OSError as problem:
            raise RoutineError(f"{path}: {problem.strerror}: make it writable") from None
        self._handles.append(handle)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            owner = sanitize(os.pread(handle, LONGEST, 0).decode(errors="replace")) or "another process"
            raise RoutineError(f"{robot} is led by {owner}: stop that first, or wait for its end") from None
        os.ftruncate(handle, 0)
        os.pwrite(handle, self._owner.encode()[:LONGEST], 0)

    def release(self) -> None:
        """Let others lead the robots."""
        for handle in self._handles:
            os.close(handle)
        self._handles.clear()


def owner_of(folder: Path, robot: str, url: str) -> str:
    """Return the present owner of a robot, empty if there is none."""
    try:
        handle = os.open(folder / f"{_key(robot, url)}.lock", os.O_RDONLY | os.O_CLOEXEC)
    except OSError:
        return ""
    try:
        fcntl.flock(handle, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except OSError:
        return sanitize(os.pread(handle, LONGEST, 0).decode(errors="replace")) or "another process"
    finally:
        os.close(handle)
    return ""


def _key(robot: str, url: str) -> str:
    return hashlib.sha256(f"{url}\n{robot}".encode()).hexdigest()[:16]
