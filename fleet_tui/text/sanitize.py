"""Text from outside made safe to show, and measured in terminal cells."""

import unicodedata
from collections.abc import Iterator
from functools import lru_cache
from textwrap import wrap
from typing import overload

from fleet_tui.text.language import Message

_UNSEEN = frozenset({"Cf", "Zl", "Zp", "Cs", "Co", "Cn"})
# Letters that fill a cell without a mark: Hangul fillers, the braille blank, variation selectors.
_BLANK = frozenset("\u115f\u1160\u3164\uffa0\u2800") | {chr(c) for c in range(0xFE00, 0xFE10)}
MAX_MARKS = 2  # maximum combining marks of a letter; more of them extend into other rows


def _safe(letter: str) -> str:
    code = ord(letter)
    if code < 0x20:
        return chr(0x2400 + code)
    if code == 0x7F:
        return "␡"
    if 0x80 <= code < 0xA0 or letter in _BLANK or unicodedata.category(letter) in _UNSEEN:
        return "\ufffd"
    return " " if letter.isspace() else letter


@overload
def sanitize(text: Message) -> Message: ...
@overload
def sanitize(text: str) -> str: ...
def sanitize(text: str) -> str:
    """Return `text` without anything that moves the cursor, hides, or turns the reading direction.

    Control characters become their pictures (ESC: ␛), all other invisible ones U+FFFD. A message stays one.
    """
    if text.isascii() and text.isprintable():
        return text
    if isinstance(text, Message):
        return text.changed(sanitize)
    return _made_visible(text)


@lru_cache(maxsize=1024)
def _made_visible(text: str) -> str:
    shown: list[str] = []
    marks = 0
    for letter in text:
        if unicodedata.combining(letter) or unicodedata.category(letter) in ("Mn", "Me"):
            marks += 1
            if not shown or marks > MAX_MARKS or letter in _BLANK:
                continue
        else:
            marks = 0
        shown.append(_safe(letter) if not marks else letter)
    return "".join(shown)


def letter_width(letter: str) -> int:
    """Return the width of one character in terminal cells: 0, 1 or 2."""
    if unicodedata.category(letter) in ("Mn", "Me"):
        return 0
    return 2 if unicodedata.east_asian_width(letter) in ("W", "F") else 1


def cell_width(text: str) -> int:
    """Return the width of `text` in terminal cells."""
    return len(text) if text.isascii() else _measured(text)


@lru_cache(maxsize=1024)
def _measured(text: str) -> int:
    return sum(map(letter_width, text))


def cells_of(text: str) -> Iterator[tuple[str, int]]:
    """Yield each character with its width in cells; marks without a width of their own are left out."""
    for letter in text:
        width = letter_width(letter)
        if width:
            yield letter, width


def fit(text: str, cells: int, right: bool = False) -> str:
    """Return `text`, sanitized, in exactly `cells` cells: cut with `…`, or padded (at the left if
    `right`)."""
    text = sanitize(text)
    width = cell_width(text)
    if width > cells:
        text, width = _cut(text, cells)
    pad = " " * (cells - width)
    return pad + text if right else text + pad


def _cut(text: str, cells: int) -> tuple[str, int]:
    """Return the start of `text` with an ellipsis in at most `cells` cells, and its width."""
    if cells < 1:
        return "", 0
    kept, width = [], 0
    for letter in text:
        width += letter_width(letter)
        if width > cells - 1:
            width -= letter_width(letter)
            break
        kept.append(letter)
    return "".join(kept) + "…", width + 1


def without_cells(text: str, start: int, cells: int) -> str:
    """Return a text without so many cells from `start` on; a blank is in the place of half a letter."""
    if text.isascii():
        return text[:start] + text[start + cells :]
    kept, at, end = [], 0, start + cells
    for letter in text:
        after = at + letter_width(letter)
        outside = after <= start or at >= end
        kept.append(letter if outside else " " * (max(0, start - at) + max(0, after - end)))
        at = after
    return "".join(kept)


def folded(text: str, first: int, others: int) -> list[str]:
    """Return a text as lines, at least one, of which the first has other cells than those below it."""
    if any(letter_width(letter) > 1 for letter in text):
        first, others = first // 2, others // 2
    first, others = max(1, first), max(1, others)
    width, above, below = max(first, others), " " * (others - first), " " * (first - others)
    lines = wrap(text, width, initial_indent=above, subsequent_indent=below, break_on_hyphens=False)
    return [line.lstrip() for line in lines or [""]]


def fit_words(text: str, cells: int) -> str:
    """Return `text` as `fit` does, but cut after a whole word if that leaves half of the cells."""
    shown = fit(text, cells)
    start = shown.rstrip()[:-1]
    if cell_width(sanitize(text)) <= cells or not start or sanitize(text)[len(start) :].startswith(" "):
        return shown
    kept = start.rpartition(" ")[0].rstrip(" ,;:")
    return fit(f"{kept}…", cells) if 2 * cell_width(kept) >= cells else shown
