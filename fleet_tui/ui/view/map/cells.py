"""A picture in terminal cells: one plane of characters, one of style roles; and its conversion to text."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from fleet_tui.text.sanitize import cells_of
from fleet_tui.ui.view.roles import StyleRole

Codes = NDArray[np.uint32]
Roles = NDArray[np.unsignedinteger[Any]]
Run = tuple[str, int]
"""Text and its style role (a `StyleRole`'s number)."""

_TAIL = 0  # the code in the second cell of a wide character
_BLANK = 0x20
_FEW = 40  # number of texts up to which writing one by one is faster


@dataclass(frozen=True, slots=True, eq=False)
class Cells:
    """codes: uint32 code points, roles: `StyleRole`s as uint8, both of shape (height, width). In a
    picture of a camera roles are uint16: further numbers are its own colours."""

    codes: Codes
    roles: Roles

    @classmethod
    def blank(cls, width: int, height: int, role: StyleRole) -> Self:
        """Return spaces in one role."""
        shape = (height, width)
        return cls(np.full(shape, _BLANK, np.uint32), np.full(shape, role, np.uint8))

    def copy(self) -> "Cells":
        return Cells(self.codes.copy(), self.roles.copy())

    def write(self, x: int, y: int, text: str, role: StyleRole) -> None:
        """Write safe `text` at cell (x, y) in place; text beyond the row is cut."""
        height, width = self.codes.shape
        codes = _codes_of(text)
        if x < 0 or x + len(codes) > width:
            codes, x = _clipped(codes, x, width)
        if not (codes and 0 <= y < height):
            return
        row, after = self.codes[y], x + len(codes)
        # A wide character that loses one half loses the other too.
        if row[x] == _TAIL:
            row[x - 1] = _BLANK
        if after < width and row[after] == _TAIL:
            row[after] = _BLANK
        row[x:after] = codes
        self.roles[y, x:after] = role

    def write_all(self, texts: Sequence[tuple[int, int, str, StyleRole]]) -> None:
        """Write many texts (x, y, text, role) at once, of letters one cell wide."""
        if len(texts) < _FEW:
            for text in texts:
                self.write(*text)
            return
        height, width = self.codes.shape
        xs, ys, words, roles = zip(*texts, strict=True)
        sizes = np.array([len(word) for word in words])
        letters = np.arange(sizes.sum()) - np.repeat(sizes.cumsum() - sizes, sizes)
        x, y = np.repeat(xs, sizes) + letters, np.repeat(ys, sizes)
        kept = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        places = (y * width + x)[kept]
        codes = self.codes.reshape(-1)
        after = places[places + 1 < codes.size] + 1
        codes[places[codes[places] == _TAIL] - 1] = _BLANK
        codes[after[codes[after] == _TAIL]] = _BLANK
        codes[places] = np.frombuffer("".join(words).encode("utf-32-le"), np.uint32)[kept]
        self.roles.reshape(-1)[places] = np.repeat(np.frombuffer(bytes(roles), np.uint8), sizes)[kept]

    def changes(self, before: "Cells | None") -> list[tuple[int, int, int]]:
        """Return the differences from `before`: (y, first x, end x) per changed row."""
        height, width = self.codes.shape
        if before is None or before.codes.shape != self.codes.shape:
            return [(y, 0, width) for y in range(height)]
        differs = (self.codes != before.codes) | (self.roles != before.roles)
        rows = np.flatnonzero(differs.any(axis=1))
        first = differs[rows].argmax(axis=1)
        last = width - differs[rows, ::-1].argmax(axis=1)
        return list(zip(rows.tolist(), first.tolist(), last.tolist(), strict=True))

    def runs(self, y: int) -> list[Run]:
        """Return row y as runs of one role each, exactly the picture's width together."""
        return _runs(self.codes[y], self.roles[y])

    def all_runs(self) -> list[list[Run]]:
        """Return the runs of every row."""
        return [_runs(codes, roles) for codes, roles in zip(self.codes, self.roles, strict=True)]

    def text(self) -> str:
        """Return the characters alone, one line per row."""
        return "\n".join("".join(text for text, _ in runs) for runs in self.all_runs())


def _runs(codes: Codes, roles: Roles) -> list[Run]:
    text = codes.tobytes().decode("utf-32-le")
    starts = [0, *(np.flatnonzero(roles[1:] != roles[:-1]) + 1).tolist()]
    ends = [*starts[1:], len(text)]
    found = [
        (text[start:end], role) for start, end, role in zip(starts, ends, roles[starts].tolist(), strict=True)
    ]
    if "\0" in text:
        return [(part.replace("\0", ""), role) for part, role in found]
    return found


@lru_cache(maxsize=4096)
def _codes_of(text: str) -> tuple[int, ...]:
    """Return one code per cell."""
    codes: list[int] = []
    for letter, size in cells_of(text):
        codes += (ord(letter),) if size == 1 else (ord(letter), _TAIL)
    return tuple(codes)


def _clipped(codes: tuple[int, ...], x: int, width: int) -> tuple[tuple[int, ...], int]:
    """Return the codes inside 0..width of those at x, and their start; half characters become blanks."""
    start, end = max(-x, 0), max(width - x, 0)
    kept = list(codes[start:end])
    if kept and kept[0] == _TAIL:
        kept[0] = _BLANK
    if kept and codes[end : end + 1] == (_TAIL,):
        kept[-1] = _BLANK
    return tuple(kept), max(x, 0)
