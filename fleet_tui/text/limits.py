"""Limits on input from outside: the rest is cut, visibly. See docs/limits.md."""

from collections.abc import Sequence
from typing import overload

from fleet_tui.text.language import EMPTY, Message

LONGEST_NAME = 200
"""Maximum characters of a label, a status or a frame id."""
LONGEST_WORDS = 500
"""Maximum characters of an answer, a reason or a description of bad data."""
MOST_ORDERS = 500
"""Maximum orders of one robot's queue."""
MOST_VERTICES = MOST_LABELS = 20_000
"""Maximum vertices, and labels, of one floor as one robot knows it."""
MOST_EDGES = 50_000
"""Maximum edges of one such graph."""
MOST_FACILITIES = 500
"""Maximum lifts, doors and the like of all sites."""
MOST_FRAMES = 1000
"""Maximum static frames of one message, and of one robot."""


@overload
def truncate(text: Message, longest: int = LONGEST_WORDS) -> Message: ...
@overload
def truncate(text: str, longest: int = LONGEST_WORDS) -> str: ...
def truncate(text: str, longest: int = LONGEST_WORDS) -> str:
    """Return `text`, or its beginning with its total length."""
    if len(text) <= longest:
        return text
    return Message("{text}… ({count} characters)", text=text[:longest], count=f"{len(text):,}")


def too_many(count: int, most: int, what: Message) -> Message:
    """Return the message on a list that is too long, empty if it isn't."""
    if count <= most:
        return EMPTY
    return Message(
        "{count} {what}: only the first {most} used", count=f"{count:,}", what=what, most=f"{most:,}"
    )


def some(names: Sequence[str]) -> str:
    """Return the first three names."""
    return ", ".join(names[:3]) + (", …" if len(names) > 3 else "")
