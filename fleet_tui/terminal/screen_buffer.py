"""The wanted cells of the terminal, the shown ones, and the bytes between them."""

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import chain
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray
from rich.cells import split_graphemes
from rich.color import Color, ColorSystem, ColorType
from rich.color_triplet import ColorTriplet
from rich.segment import Segment
from rich.style import Style

from fleet_tui.terminal.cell_strip import CellStrip


class Sgr(NamedTuple):
    """SGR parameters; empty means the terminal's own."""

    weight: str = ""
    color: str = ""
    on: str = ""


PLAIN = Sgr()
RESET = "\x1b[m"

_WEIGHTS = {
    "1": "bold",
    "2": "dim",
    "3": "italic",
    "4": "underline",
    "5": "blink",
    "7": "reverse",
    "9": "strike",
    "21": "underline2",
    "53": "overline",
}


@lru_cache(4096)
def look_of(style: Style | None, colours: ColorSystem | None) -> Sgr:
    """Return a Rich style with the terminal's number of colours; None: no colour at all."""
    if style is None:
        return PLAIN
    weight = ";".join(code for code, name in _WEIGHTS.items() if getattr(style, name))
    if colours is None:
        return Sgr(weight)
    color, on = _code(style.color, colours, True), _code(style.bgcolor, colours, False)
    if colours is ColorSystem.STANDARD and color and on and style.color != style.bgcolor:
        color = _apart(color, on)
    return Sgr(weight, color, on)


def filled(look: Sgr) -> Sgr:
    """Return a look with its ground in the colour of its characters."""
    if not look.color:
        return look
    first, *rest = look.color.split(";")
    return look._replace(on=";".join([str(int(first) + 10), *rest]))


def _apart(color: str, on: str) -> str:
    """Return a foreground that differs from its ground: with 16 colours a quiet one may equal it, the greys
    beside it don't."""
    if int(color) + 10 != int(on):
        return color
    return "37" if on == "100" else "90"


def _code(color: Color | None, colours: ColorSystem, foreground: bool) -> str:
    if color is None or color.is_default:
        return ""
    if color.type is ColorType.TRUECOLOR and color.triplet:
        if colours is ColorSystem.EIGHT_BIT:
            color = Color.from_ansi(nearest(color.triplet))
        elif colours is ColorSystem.STANDARD:
            color = Color.from_ansi(sixteen(color.triplet))
    return ";".join(color.downgrade(colours).get_ansi_codes(foreground))


_TINTED = 42  # difference between maximum and minimum of red, green and blue below which a colour is grey
_COLOURED = 56  # the same with only six hues
_GREYS = ((50, 0), (145, 8), (215, 7), (256, 15))
_BRIGHT = 200


@lru_cache(1024)
def sixteen(triplet: ColorTriplet) -> int:
    """Return the one of the 16 colours with its hue, or with its lightness if it has hardly any.

    Rich takes the nearest by distance, which makes a dark red brown: yellow on most terminals.
    """
    low, high = min(triplet), max(triplet)
    if high - low < _COLOURED:
        return next(number for limit, number in _GREYS if sum(triplet) / 3 < limit)
    hue = sum(1 << bit for bit, part in enumerate(triplet) if part > low + 0.55 * (high - low))
    return hue + 8 if high > _BRIGHT else hue


_CUBE = (0, 95, 135, 175, 215, 255)


@lru_cache(1024)
def nearest(triplet: ColorTriplet) -> int:
    """Return the nearest of the 240 fixed colours of a 256-colour terminal.

    Rich looks for tinted colours only in the cube, whose darkest steps are 0 and 95: every dark ground
    becomes the same black. The greys between them keep grounds apart. A slightly bluish grey counts as grey
    here: the nearest in the cube would be teal or purple.
    """
    if max(triplet) - min(triplet) < _TINTED:
        triplet = ColorTriplet(*[round(sum(triplet) / 3)] * 3)
    cube = [min(range(6), key=lambda step: abs(_CUBE[step] - part)) for part in triplet]
    grey = max(0, min(23, round((sum(triplet) / 3 - 8) / 10)))
    in_cube = sum((_CUBE[step] - part) ** 2 for step, part in zip(cube, triplet, strict=True))
    in_greys = sum((8 + 10 * grey - part) ** 2 for part in triplet)
    return 232 + grey if in_greys < in_cube else 16 + 36 * cube[0] + 6 * cube[1] + cube[2]


@lru_cache(4096)
def turn(before: Sgr, after: Sgr) -> str:
    """Return the shortest sequence that changes `before` into `after`."""
    if before == after:
        return ""
    parts = []
    if before.weight and before.weight != after.weight:
        # Single weights can't be unset on every terminal: reset first.
        parts, before = ["0"], PLAIN
    if before.weight != after.weight:
        parts.append(after.weight)
    if before.color != after.color:
        parts.append(after.color or "39")
    if before.on != after.on:
        parts.append(after.on or "49")
    return f"\x1b[{';'.join(parts)}m"


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
