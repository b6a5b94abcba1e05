"""Limits on input from outside: anything beyond is cut, and the cut is shown. See docs/bounds.md."""

from collections.abc import Sequence

LONGEST_NAME = 200
"""Characters of a label, a status or a frame id."""
LONGEST_WORDS = 500
"""Characters of an answer, a reason or a description of bad data."""
MOST_ORDERS = 500
"""Orders of one robot's queue."""
MOST_VERTICES = MOST_LABELS = 20_000
"""Vertices, and labels, of one floor as one robot knows it."""
MOST_EDGES = 50_000
"""Edges of one such graph."""


def truncate(text: str, longest: int = LONGEST_WORDS) -> str:
    """`text`, or its beginning and how long all of it is."""
    return text if len(text) <= longest else f"{text[:longest]}… ({len(text):,} characters)"


def too_many(count: int, most: int, what: str) -> str:
    """Return what to say of a list that is too long, empty if it isn't."""
    return f"{count:,} {what}: only the first {most:,} used" if count > most else ""


def some(names: Sequence[str]) -> str:
    """Name the first three."""
    return ", ".join(names[:3]) + (", …" if len(names) > 3 else "")
