"""Objections to a command, and the permissions of a console."""

from enum import IntEnum

from msgspec import Struct

from fleet_tui.text.language import EMPTY, Message


class Problem(Struct, frozen=True):
    """`check` is the name of the check. `blocks`: an error, the command is never sent; else a warning, which
    a person may override."""

    check: str
    text: Message
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

    def refusal(self, needed: Right) -> Message:
        """Return the reason that the user may not do what needs a right, empty if they may."""
        if self.right >= needed:
            return EMPTY
        if self.why:
            return Message("not allowed: {right} ({why})", right=needed.word, why=Message(self.why))
        return Message("not allowed: {right}", right=needed.word)
