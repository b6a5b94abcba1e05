"""Presence: one file per console, replaced every few seconds, and a lock that its process holds.

The kernel releases the lock of a killed process: consoles of one machine see its end at once, also on a
network file system. Of other machines a console has gone when its file no longer changes. No clocks are
compared, but at the first look.
"""

import errno
import os
import secrets
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta, Struct

from fleet_tui.records.desk.facts import Name, ShelvedFor
from fleet_tui.storage.handles import open_shared
from fleet_tui.storage.lock import LockFile, owner_of
from fleet_tui.storage.whole_file import replace_shared
from fleet_tui.text.language import in_english

PREFIX = "console-"
SUFFIX = ".json"
LOCK = ".lock"
BEAT = 2.0
"""Seconds after which a console that did nothing renews its file."""
GONE_AFTER = 8.0
"""Seconds without a new file after which a console has gone."""
FORGOTTEN_AFTER = 3600.0
"""Seconds after which others remove the files of a console of another machine."""
LARGEST = 200_000
MOST_FILES = 200

Keys = Annotated[tuple[tuple[Name, Name], ...], Meta(max_length=1000)]


class Presence(Struct, frozen=True, omit_defaults=True):
    """One console at the desk: `name` is its operator, `boot` the machine's run; `acknowledged` and `shelved`
    (with seconds left) are for a console that has just come."""

    id: Name
    name: Name
    host: Name
    boot: Name
    robot: Name = ""
    claims: Annotated[tuple[Name, ...], Meta(max_length=1000)] = ()
    acknowledged: Keys = ()
    shelved: Annotated[tuple[tuple[Name, Name, ShelvedFor], ...], Meta(max_length=1000)] = ()


_DECODER = msgspec.json.Decoder(Presence)


def boot_id() -> str:
    """Return what identifies this run of this machine's kernel, empty if unknown."""
    with suppress(OSError):
        return Path("/proc/sys/kernel/random/boot_id").read_text().strip()
    return ""


def new_console_id() -> str:
    """Return an id for this console that no other one has: its host, its process, and a random part."""
    return f"{os.uname().nodename[:60]}-{os.getpid()}-{secrets.token_hex(4)}"


class PresenceFile:
    """The file of this console, and its lock."""

    def __init__(self, folder: Path) -> None:
        self.id = new_console_id()
        self._path = folder / f"{PREFIX}{self.id}{SUFFIX}"
        self._lock = LockFile(self._path.with_suffix(LOCK), open_shared)
        self._last: Presence | None = None
        self._last_at = 0.0

    def keep(self, presence: Presence) -> None:
        """Write the file if it has changed or is due. Raises OSError."""
        now = time.monotonic()
        is_there = self._lock.is_held
        if is_there and self._last == presence and now - self._last_at < BEAT:
            return
        if not self._lock.take():
            raise BlockingIOError(errno.EAGAIN, f"{self._lock.path.name} is locked by another console")
        replace_shared(self._path, msgspec.json.encode(presence, enc_hook=in_english))
        self._last = presence
        self._last_at = now

    def close(self) -> None:
        """Leave the desk."""
        if self._lock.is_held:
            _remove(self._path)
        self._lock.release()


class _FileSeen(Struct):
    """A file at the last look: its identity, the time (monotonic) at which that was new, its content."""

    stamp: tuple[int, int, int]
    since: float
    presence: Presence | None


class PresenceReader:
    """The other consoles at the desk."""

    def __init__(self, folder: Path, own: str = "") -> None:
        self._folder = folder
        self._own = own
        self._boot = boot_id()
        self._seen: dict[str, _FileSeen] = {}
        self.ignored = 0
        """Files at the last look that are no presence of a console."""

    def look(self) -> list[Presence]:
        """Return the consoles that are there now, by name. Raises OSError."""
        now, found, known = time.monotonic(), list[Presence](), set[str]()
        self.ignored = 0
        for entry in self._files():
            known.add(entry.name)
            seen = self._seen_file(entry, now)
            if seen is None or seen.presence is None:
                self.ignored += seen is not None
            elif self._is_there(Path(entry.path), seen, now):
                found.append(seen.presence)
        self._seen = {name: seen for name, seen in self._seen.items() if name in known}
        return sorted(found, key=lambda one: (one.name, one.id))

    def _files(self) -> Iterator["os.DirEntry[str]"]:
        with os.scandir(self._folder) as entries:
            named = [one for one in entries if one.name.startswith(PREFIX) and one.name.endswith(SUFFIX)]
        own = f"{PREFIX}{self._own}{SUFFIX}"
        yield from [one for one in named if one.name != own][:MOST_FILES]

    def _seen_file(self, entry: "os.DirEntry[str]", now: float) -> _FileSeen | None:
        """Return a file as it is now, None if it has just gone."""
        try:
            status = entry.stat(follow_symlinks=False)
        except FileNotFoundError:
            return None
        stamp = status.st_ino, status.st_mtime_ns, status.st_size
        seen = self._seen.get(entry.name)
        if seen is not None and seen.stamp == stamp:
            return seen
        # At the first look the age is by the clock: what a dead console left does not come to life.
        age = max(0.0, time.time() - status.st_mtime) if seen is None else 0.0
        self._seen[entry.name] = _FileSeen(stamp, now - age, _presence(Path(entry.path)))
        return self._seen[entry.name]

    def _is_there(self, path: Path, seen: _FileSeen, now: float) -> bool:
        assert seen.presence is not None
        is_here = seen.presence.boot == self._boot != ""
        if is_here and owner_of(path.with_suffix(LOCK), open_shared) is None:
            _remove(path)
            return False
        if not is_here and now - seen.since > FORGOTTEN_AFTER:
            _remove(path)
        return now - seen.since <= GONE_AFTER


def _remove(path: Path) -> None:
    """Remove the files of a console that has gone; whoever comes first."""
    for one in (path, path.with_suffix(LOCK)):
        with suppress(OSError):
            one.unlink()


def _read(path: Path, largest: int) -> bytes:
    with os.fdopen(open_shared(path, os.O_RDONLY), "rb") as file:
        content = file.read(largest + 1)
    if len(content) > largest:
        raise OSError(errno.EFBIG, f"{path.name} is over {largest:,} bytes")
    return content


def _presence(path: Path) -> Presence | None:
    """Return the content of a file, None if it is no presence, or another's."""
    try:
        found = _DECODER.decode(_read(path, LARGEST))
    except (OSError, msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
        return None
    return found if path.name == f"{PREFIX}{found.id}{SUFFIX}" else None
