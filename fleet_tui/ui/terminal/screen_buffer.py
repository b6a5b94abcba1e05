"""The wanted cells of the terminal, the shown ones, and the bytes between them."""

import re
from collections.abc import Iterable, Sequence
from itertools import chain
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from rich.cells import split_graphemes
from rich.color import ColorSystem
from rich.segment import Segment
from rich.style import Style

from fleet_tui.ui.terminal.cell_strip import CellStrip
from fleet_tui.ui.terminal.sgr import PLAIN, RESET, Sgr, filled, look_of, turn

Cells = NDArray[np.uint64]

# A cell is one number: its character in the low bits, its style's number above.
_SHIFT = np.uint64(32)
_CODE = np.uint64(0xFFFFFFFF)
_NOTHING = np.uint64(0xFFFFFFFFFFFFFFFF)
"""Unknown: as wanted, leave the cell alone; as sent, always send it."""

_BLANK = np.uint64(ord(" "))
_BLOCK = ord("█")
"""Some fonts leave gaps between full blocks: the ground behind them closes those."""
_TAIL = 0  # the character in the second cell of a wide one
_CLUSTERS = 0x110000  # characters from here on are those of `clusters`

ONE_CELL_EACH = re.compile(
    "[ -~\u00a1-\u00ac\u00ae-\u02ff\u0370-\u0373\u0391-\u0482\u048a-\u04ff\u2010-\u2027\u2030-\u205e"
    "\u2190-\u2319\u2400-\u2426\u2500-\u25fc\u2800-\u28ff]*"
)
"""Characters that surely take one cell; for the rest the width is looked up."""

# Characters without width but with effects: controls, reading direction, invisibility.
_CONTROLS = dict.fromkeys(
    chain(
        range(0x20),
        range(0x7F, 0xA0),
        (0x61C, 0x200B, 0x200E, 0x200F, 0xFEFF),
        range(0x2028, 0x202F),
        range(0x2060, 0x2070),
        range(0xE0000, 0xE0080),
    )
)

REMEMBERED = 4096
"""Number of styles, and of odd characters, above which those out of view are dropped."""

Named = TypeVar("Named", Sgr, str)


class ScreenBuffer:
    """Takes the wanted cells by `put`; `take` returns the bytes that make the terminal show them."""

    def __init__(self, colours: ColorSystem | None) -> None:
        self._colours = colours
        self._wanted: NDArray[np.uint64] = np.empty((0, 0), np.uint64)
        self._sent = self._wanted
        self.looks: dict[Sgr, int] = {}
        self.clusters: dict[str, int] = {}
        self._styles: Sequence[Style] = ()
        self._roles: NDArray[np.uint64] = np.empty(0, np.uint64)
        self._blocks = self._roles

    def fit(self, width: int, height: int) -> None:
        """Resize to this many cells; all cells are unknown afterwards."""
        if self._wanted.shape != (height, width):
            self._wanted = np.full((height, width), _NOTHING)
            self._sent = self._wanted.copy()

    def forget(self) -> None:
        """Mark all cells as unknown: every one is sent again."""
        self._sent.fill(_NOTHING)

    def _tidy(self) -> None:
        """Renumber the entries in view, and drop the rest."""
        cells = np.concatenate((self._wanted.ravel(), self._sent.ravel()))
        known = cells != _NOTHING
        looks, codes = cells >> _SHIFT, cells & _CODE
        self.looks, looks[known] = _used(self.looks, looks[known], 0)
        odd = known & (codes >= _CLUSTERS)
        self.clusters, codes[odd] = _used(self.clusters, codes[odd], _CLUSTERS)
        cells[known] = (looks << _SHIFT | codes)[known]
        self._wanted, self._sent = cells.reshape(2, *self._wanted.shape)
        self._styles = ()

    def put(self, x: int, y: int, end: int, segments: Iterable[Segment]) -> None:
        """Set `segments` in row y from cell x on, up to cell `end`."""
        cells = self._packed(segments) if isinstance(segments, CellStrip) else self._spelled(segments)
        self._part(x, y)
        self._part(end, y)
        row = self._wanted[y, x:end]
        row[: len(cells)] = cells[: len(row)]

    def _packed(self, strip: CellStrip) -> NDArray[np.uint64]:
        if strip.styles is not self._styles:
            self._styles = strip.styles
            looks = [look_of(style, self._colours) for style in strip.styles]
            self._roles = self._numbers(looks)
            self._blocks = self._numbers(filled(look) for look in looks)
        cells = strip.codes | self._roles[strip.roles]
        blocks = strip.codes == _BLOCK
        cells[blocks] = _BLOCK | self._blocks[strip.roles[blocks]]
        return cells

    def _spelled(self, segments: Iterable[Segment]) -> NDArray[np.uint64]:
        texts = [(text, style) for text, style, control in segments if text and not control]
        line = "".join([text for text, _ in texts])
        looks = [look_of(style, self._colours) for _, style in texts]
        if ONE_CELL_EACH.fullmatch(line):
            codes = np.frombuffer(line.encode("utf-32-le"), np.uint32)
            sizes = [len(text) for text, _ in texts]
        else:
            parts = [self._cells(text) for text, _ in texts]
            codes = np.array([code for part in parts for code in part], np.uint32)
            sizes = [len(part) for part in parts]
        cells = codes | np.repeat(self._numbers(looks), sizes)
        if "█" in line:
            blocks = codes == _BLOCK
            cells[blocks] = _BLOCK | np.repeat(self._numbers(map(filled, looks)), sizes)[blocks]
        return cells

    def _part(self, x: int, y: int) -> None:
        """Return a part of a row; a wide character on both sides of the left edge of cell x becomes
        blanks."""
        row = self._wanted[y]
        if x < len(row) and row[x] & _CODE == _TAIL:
            row[x - 1 : x + 1] = row[x - 1] & ~_CODE | _BLANK

    def _numbers(self, looks: Iterable[Sgr]) -> NDArray[np.uint64]:
        return np.array([self._look(look) for look in looks], np.uint64) << _SHIFT

    def _look(self, look: Sgr) -> int:
        return self.looks.setdefault(look, len(self.looks))

    def _cells(self, text: str) -> list[int]:
        """Return one character number per cell."""
        codes = []
        text = text.translate(_CONTROLS)
        for start, end, width in split_graphemes(text)[0]:
            part = text[start:end]
            if width:
                plain = len(part) == 1
                codes.append(
                    ord(part) if plain else self.clusters.setdefault(part, _CLUSTERS + len(self.clusters))
                )
                codes += [_TAIL] * (width - 1)
        return codes

    def take(self) -> str:
        """Return the bytes for all differences, which count as sent from now on; the style ends plain."""
        changed = (self._wanted != self._sent) & (self._wanted != _NOTHING)
        places = np.flatnonzero(changed)
        if not places.size:
            return ""
        if max(len(self.looks), len(self.clusters)) > REMEMBERED:
            self._tidy()
        cells = self._wanted.ravel()[places]
        self._sent[changed] = cells
        keep = (cells & _CODE) != _TAIL  # sent with the cell before it
        places, cells = places[keep], cells[keep]
        # Style by style: a change of style takes 20 to 40 bytes, a move of the cursor 8.
        order = np.lexsort((places, cells >> _SHIFT))
        return self._written(places[order], cells[order])

    def _written(self, places: NDArray[np.intp], cells: NDArray[np.uint64]) -> str:
        width = self._wanted.shape[1]
        codes, looks = (cells & _CODE).astype(np.uint32), cells >> _SHIFT
        starts = _starts(places, codes, looks, width)
        named = list(self.looks)
        clusters = list(self.clusters)
        text = np.where(codes < _CLUSTERS, codes, ord("?")).tobytes().decode("utf-32-le", "replace")
        plain = ONE_CELL_EACH.fullmatch(text) and codes.max() < _CLUSTERS
        out, look, cursor = [], PLAIN, -1
        ends = [*starts[1:], len(text)]
        first = zip(places[starts].tolist(), codes[starts].tolist(), looks[starts].tolist(), strict=True)
        for start, end, (place, code, number) in zip(starts, ends, first, strict=True):
            out.append(_move(cursor, place, width))
            if named[number] is not look:
                out.append(turn(look, named[number]))
            out.append(clusters[code - _CLUSTERS] if code >= _CLUSTERS else text[start:end])
            look = named[number]
            # Terminals disagree about the width of non-plain characters: position the cursor explicitly.
            # The last column too: there the cursor waits beside the screen.
            cursor = place + end - start
            if cursor % width == 0 or not (plain or ONE_CELL_EACH.fullmatch(out[-1])):
                cursor = -1
        if look != PLAIN:
            out.append(RESET)
        return "".join(out)


def _used(table: dict[Named, int], used: Cells, first: int) -> tuple[dict[Named, int], Cells]:
    """Return the used part of a table, numbered from `first` on, and the old entries by their new numbers."""
    names = list(table)
    old, new = np.unique(used, return_inverse=True)
    kept = {names[number - first]: first + place for place, number in enumerate(old.tolist())}
    return kept, new.astype(np.uint64) + np.uint64(first)


def _starts(
    places: NDArray[np.intp], codes: NDArray[np.uint32], looks: NDArray[np.uint64], width: int
) -> list[int]:
    """Return the starts of runs: at a gap, another style, another row, before and after non-plain
    characters."""
    odd = codes >= _CLUSTERS
    begins = np.ones(len(places), bool)
    begins[1:] = (
        (np.diff(places) != 1) | (looks[1:] != looks[:-1]) | (places[1:] % width == 0) | odd[1:] | odd[:-1]
    )
    return np.flatnonzero(begins).tolist()


def _move(cursor: int, place: int, width: int) -> str:
    """Return the move of the cursor from one place to another, both counted row by row; -1: unknown."""
    if place == cursor:
        return ""
    y, x = divmod(place, width)
    if 0 <= cursor < place and cursor // width == y:
        ahead = place - cursor
        return f"\x1b[{ahead if ahead > 1 else ''}C"
    return f"\x1b[{y + 1};{x + 1}H"
