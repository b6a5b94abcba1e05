"""Objections to a command, and the permissions of a console."""

from enum import IntEnum

from msgspec import Struct


class Problem(Struct, frozen=True):
    """`check` is the name of the check. `blocks`: an error, the command is never sent; else a warning, which
    a person may override."""

    check: str
    text: str
    blocks: bool = True


class Right(IntEnum):
    """A right that the administrator of the machine gives a user; each includes those before it."""

    VIEW = 0
    DISPATCH = 1
    SETUP = 2

    @property
    def word(self) -> str:
        """Return its name in files and messages."""
        return self.name.lower()


class Permissions(Struct, frozen=True):
    """The permissions of this console; `right` is that of its user, `why` the reason for no more."""

    read_only: bool = False
    armed: bool = True
    right: Right = Right.SETUP
    why: str = ""

    def refusal(self, needed: Right) -> str:
        """Return the reason that the user may not do what needs a right, empty if they may."""
        if self.right >= needed:
            return ""
        return f"not allowed: {needed.word}" + (f" ({self.why})" if self.why else "")
