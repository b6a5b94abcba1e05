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

    def objection(self, needed: Right, arms: bool = True) -> Problem | None:
        """Return what keeps this console from what needs a right, None if nothing does. `arms`: it needs an
        armed console."""
        if refusal := self.refusal(needed):
            return Problem("not allowed", refusal)
        if self.read_only:
            return Problem("read-only", Message("this console is read-only"))
        if arms and not self.armed:
            return Problem("not armed", Message("this console is not armed: use Arm in the palette (:)"))
        return None
