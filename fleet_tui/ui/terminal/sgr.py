"""The style of a cell, as SGR parameters (the escape sequence that sets colours and weight)."""

from functools import lru_cache
from typing import NamedTuple

from rich.color import Color, ColorSystem, ColorType
from rich.color_triplet import ColorTriplet
from rich.style import Style


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
