"""What speaks against a command."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Problem:
    """`check` is the name of what was looked at. `blocks`: an error, the command is never sent; else a
    warning, which a person may override."""

    check: str
    text: str
    blocks: bool = True


@dataclass(frozen=True, slots=True)
class Rights:
    """What this console may do."""

    read_only: bool = False
    armed: bool = True
