"""What speaks against a command."""

from msgspec import Struct


class Problem(Struct, frozen=True):
    """`check` is the name of what was looked at. `blocks`: an error, the command is never sent; else a
    warning, which a person may override."""

    check: str
    text: str
    blocks: bool = True


class Permissions(Struct, frozen=True):
    """What this console may do."""

    read_only: bool = False
    armed: bool = True
