"""The owner of robots: one routine at a time gives orders to a robot, whatever process it runs in."""

import hashlib
from collections.abc import Mapping
from pathlib import Path

from fleet_tui.storage.lock import LockFile
from fleet_tui.storage.lock import owner_of as owner_of_lock
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize


class RobotLocks:
    """Locks for robots, held until `release` or the end of the process. `robots`: the URL of each one's
    bridge: robots of two sites may share a name."""

    def __init__(self, folder: Path, robots: Mapping[str, str], owner: str) -> None:
        self._folder = folder
        self._robots = robots
        self._owner = owner
        self._locks = [LockFile(_path(folder, robot, url)) for robot, url in robots.items()]

    def claim(self) -> None:
        """Become the owner. Raises RoutineError with the present one."""
        for lock, (robot, url) in zip(self._locks, self._robots.items(), strict=True):
            try:
                is_mine = lock.take(self._owner)
            except OSError as problem:
                self.release()
                raise RoutineError(
                    Message("{path}: {strerror}: make it writable", path=lock.path, strerror=problem.strerror)
                ) from None
            if not is_mine:
                self.release()
                owner = owner_of(self._folder, robot, url) or Message("another process")
                raise RoutineError(
                    Message(
                        "{robot} is run by {owner}: stop that first, or wait until it ends",
                        robot=robot,
                        owner=owner,
                    )
                )

    def release(self) -> None:
        """Let others lead the robots."""
        for lock in self._locks:
            lock.release()


def owner_of(folder: Path, robot: str, url: str) -> str:
    """Return the present owner of a robot, empty if there is none."""
    owner = owner_of_lock(_path(folder, robot, url))
    return "" if owner is None else sanitize(owner) or Message("another process")


def _path(folder: Path, robot: str, url: str) -> Path:
    key = hashlib.sha256(f"{url}\n{robot}".encode()).hexdigest()[:16]
    return folder / f"{key}.lock"
