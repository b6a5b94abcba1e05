"""Trust in files: whether somebody else could have written one, and what a person trusts all the same.

Safe is what the user of this process or root owns and nobody else can write or replace: the file, the links
that lead to it, and every folder on the way.
"""

import errno
import grp
import hashlib
import os
import pwd
import stat
from collections.abc import Collection, Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path

import platformdirs

from fleet_tui.config.small_file import read_text
from fleet_tui.text.language import EMPTY, Message

ROOT = 0
"""The user id of root."""
MOST_LINKS = 40
"""Links that the system follows on one way."""
LARGEST_MEMORY = 10_000_000
"""Bytes of the file of what is trusted."""
_ACL = "system.posix_acl_access"
"""The attribute that gives further users and groups access."""

_said_yes = ContextVar("said_yes", default=False)
_trusted: set[str] = set()
"""The digests of what is trusted in this process, also where they can't be written."""


def doubt(path: Path, owner: int | None = None, is_for_group: bool = False) -> Message:
    """Return how somebody else than `owner` (by default the user of this process) and root could have written
    a file, or can while it does not exist, with the remedy; empty if nobody could.

    `is_for_group`: its group, and an owner who is of that group, may write it.
    """
    owners = {ROOT, os.geteuid() if owner is None else owner}
    names = [user_name(one) for one in sorted(owners, reverse=True)]
    shared = EMPTY
    # How others may write to the present folder, in which nobody can replace the files of another user.
    for place, status, is_last in _way(path.absolute()):
        if status is None:
            return (
                Message(
                    "{place} does not exist, and others could make it: {shared}", place=place, shared=shared
                )
                if shared
                else EMPTY
            )
        for_group = is_for_group and is_last
        if status.st_uid not in owners and not (for_group and _is_of(status.st_uid, status.st_gid)):
            link = "-h " if stat.S_ISLNK(status.st_mode) else ""
            return Message(
                "{place} is not owned by {names}: chown {link}{owner} {place}",
                place=place,
                names=" or ".join(names),
                link=link,
                owner=names[0],
            )
        if stat.S_ISLNK(status.st_mode):  # its mode says nothing
            continue
        shared = EMPTY
        if status.st_mode & stat.S_IWOTH:
            shared = Message("{place} is writable by everyone: chmod o-w {place}", place=place)
        elif status.st_mode & stat.S_IWGRP and not for_group and _lets_others(place, status, names):
            shared = Message("{place} is writable by others: chmod g-w {place}", place=place)
        if shared and not (stat.S_ISDIR(status.st_mode) and status.st_mode & stat.S_ISVTX):
            return shared
    return EMPTY


def doubt_of_content(path: Path, text: str) -> str:
    """Return the same, empty also for a content that a person trusts in this place."""
    found = doubt(path)
    return "" if found and _digest(path, text) in _trusted | _remembered() else found


@contextmanager
def saying_yes() -> Iterator[None]:
    """Trust what is loaded meanwhile, and remember it: a person said so."""
    before = _said_yes.set(True)
    try:
        yield
    finally:
        _said_yes.reset(before)


def accept(path: Path, text: str) -> None:
    """Remember that this content is trusted in this place, if a person says so now."""
    if not _said_yes.get() or not doubt_of_content(path, text):
        return
    digest = _digest(path, text)
    _trusted.add(digest)
    file = memory()
    if doubt(file):  # what others could have laid there is not written to
        return
    with suppress(OSError):  # then it holds for this process
        file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        with os.fdopen(os.open(file, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600), "w") as lines:
            lines.write(f"{digest}\n")


def memory() -> Path:
    """Return the file of what is trusted: a digest of place and content on each line."""
    return platformdirs.user_state_path("fleet-tui") / "trusted"


def written_file(path: Path) -> Path:
    """Return the file that is written under a name, links followed. Raises OSError for a link that somebody
    else could have made: it may lead to any file of this user."""
    if path.is_symlink() and doubt(path):
        raise OSError(errno.ELOOP, "a link that another user could have made: name the file that it leads to")
    return path.resolve()


def user_name(number: int) -> str:
    """Return the name of a user, the number if it has none."""
    try:
        return pwd.getpwuid(number).pw_name
    except KeyError:
        return str(number)


def members(number: int) -> set[str]:
    """Return the names of a group's members. Raises KeyError for a group without a name."""
    return {*grp.getgrgid(number).gr_mem, *(user.pw_name for user in pwd.getpwall() if user.pw_gid == number)}


def _way(path: Path) -> Iterator[tuple[Path, os.stat_result | None, bool]]:
    """Return everything on the way to a file with its status, and whether it is the last; links are followed
    part by part. Ends at what is not there, None, or can't be seen."""
    left, place, links = list(path.parts[1:]), Path(path.anchor), 0
    yield place, place.lstat(), not left
    while left and links <= MOST_LINKS:
        part = left.pop(0)
        if part == "..":
            place = place.parent
            continue
        try:
            status = (place / part).lstat()
            target = (place / part).readlink() if stat.S_ISLNK(status.st_mode) else None
        except FileNotFoundError:
            yield place / part, None, False
            return
        except OSError:  # told by who reads it
            return
        yield place / part, status, not left and target is None
        if target is None:
            place = place / part
            continue
        links += 1
        left = [*(target.parts[1:] if target.is_absolute() else target.parts), *left]
        place = Path(target.anchor) if target.is_absolute() else place


def _lets_others(place: Path, status: os.stat_result, owners: Collection[str]) -> bool:
    """Tell whether the group of a place, which may write, has members beside the owners, or an access list
    names more users."""
    with suppress(OSError, AttributeError):  # no such list, or no such lists on this system
        if os.getxattr(place, _ACL):
            return True
    try:
        return bool(members(status.st_gid).difference(owners))
    except KeyError:  # nobody knows who is in it
        return True


def _is_of(user: int, group: int) -> bool:
    with suppress(KeyError):
        return user_name(user) in members(group)
    return False


def _digest(path: Path, text: str) -> str:
    return hashlib.sha256(b"\0".join((os.fsencode(path.absolute()), text.encode()))).hexdigest()


def _remembered() -> set[str]:
    file = memory()
    if doubt(file):
        return set()
    try:
        return set(read_text(file, LARGEST_MEMORY).split())
    except (OSError, ValueError):
        return set()
