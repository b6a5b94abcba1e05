"""Objections to a command, and the permissions of a console."""

from msgspec import Struct


class Problem(Struct, frozen=True):
    """`check` is the name of the check. `blocks`: an error, the command is never sent; else a warning, which
    a person may override."""

    check: str
    text: str
    blocks: bool = True


class Permissions(Struct, frozen=True):
    """The permissions of this console."""

    read_only: bool = False
    armed: bool = True
