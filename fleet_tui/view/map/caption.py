"""The map's first row: a thin rule with the floor, the scale and the active options."""

import math
from dataclasses import dataclass
from functools import lru_cache

from fleet_tui.model.geometry import MapFrame
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import cell_width, fit_words, sanitize
from fleet_tui.view.map.camera import Camera, scale_bar
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.roles import StyleRole

Piece = tuple[str, StyleRole]
LEAST = 8  # cells that a note must have
_BAR = 14  # cells that the scale bar may take
_BANNER = 34  # cells of a banner that are worth more than the floor


@dataclass(frozen=True, slots=True)
class Caption:
    """The content of the first row. `waits`: the note only says what has not arrived yet; `banner` is that of
    the map's mode, `pixel` the map's cell under its cursor; `hint` names the key of help, `elsewhere`
    robots in trouble out of view and on other floors, after a `!` those with an alarm; `whole`: all of the
    floor is in view."""

    floor: str
    note: str
    frame: MapFrame
    camera: Camera
    drawing: Drawing
    follow: bool
    zoom_robot: bool
    focused: bool
    waits: bool = False
    banner: str = ""
    hint: str = ""
    elsewhere: tuple[str, ...] = ()
    pixel: str = ""
    whole: bool = False


@lru_cache(maxsize=8)
def caption_row(facts: Caption) -> Cells:
    """Return one row of cells, not to be drawn on; if it is narrow, a note is cut and less important parts
    are dropped."""
    row = Cells.blank(facts.camera.width, 1, StyleRole.ACCENT if facts.focused else StyleRole.RULE)
    row.codes[:] = ord("-" if facts.drawing is Drawing.ASCII else "─")
    x = 1
    for piece, role in _pieces(facts):
        space = facts.camera.width - x - 2
        # Of these the beginning is worth more than the rest of the row.
        is_first = piece in (*map(sanitize, (facts.note, *facts.elsewhere)), facts.banner)
        if is_first and space > LEAST:
            piece = _within(piece, space)
        text = f" {piece} "
        if x + cell_width(text) <= facts.camera.width:
            row.write(x, 0, text, role)
            x += cell_width(text) + 2
    return row


def _within(text: str, cells: int) -> str:
    """Return the parts of a text, at its commas, that are whole in so many cells, else its beginning."""
    while cell_width(text) > cells and ", " in text:
        text = text.rpartition(", ")[0]
    return text if cell_width(text) <= cells else fit_words(text, cells).rstrip()


def _pieces(facts: Caption) -> list[Piece]:
    """Return the pieces from left to right, which is also the order of their importance."""
    pieces, floor = list[Piece](), sanitize(facts.floor)
    # The mode's banner begins with the cursor's place, which is seen nowhere else.
    banner = min(cell_width(facts.banner), _BANNER)
    if not banner or cell_width(floor) + banner + 7 <= facts.camera.width:
        pieces.append((floor, StyleRole.TITLE_FOCUSED if facts.focused else StyleRole.TITLE))
    if facts.banner:
        pieces.append((facts.banner, StyleRole.TEXT))
    for told in facts.elsewhere:
        pieces.append((sanitize(told), StyleRole.ALARM if told.startswith("!") else StyleRole.WARN))
    if facts.note:
        pieces.append((sanitize(facts.note), StyleRole.DIM if facts.waits else StyleRole.WARN))
    return [
        *pieces,
        *([(facts.pixel, StyleRole.TEXT)] if facts.pixel else []),
        *_following(facts),
        (_bar(facts), StyleRole.DIM),
        *_turn(facts),
        *([(tr("zoom robot"), StyleRole.DIM)] if facts.zoom_robot else []),
        *([(tr(f"{facts.hint} Tab Tab legend"), StyleRole.DIM)] if facts.hint else []),
    ]


def _following(facts: Caption) -> list[Piece]:
    """Return that the view follows a robot, and why it does not move."""
    text = tr("follow on, all in view") if facts.whole else tr("follow on")
    return [(text, StyleRole.TEXT)] if facts.follow else []


def _turn(facts: Caption) -> list[Piece]:
    """Return the rotation of the picture in the world, if any."""
    yaw = facts.frame.origin.yaw
    degrees = round(math.degrees(yaw)) if math.isfinite(yaw) else 0
    unit = tr(" deg") if facts.drawing is Drawing.ASCII else "°"
    return [(tr(f"yaw {degrees}{unit}"), StyleRole.DIM)] if degrees else []


def _bar(facts: Caption) -> str:
    metres, cells = scale_bar(facts.camera, facts.frame, _BAR)
    left, line, right = "|-|" if facts.drawing is Drawing.ASCII else "├─┤"
    # Its ends are in the middle of their cells.
    return f"{metres} {left}{line * (cells - 1)}{right}" if cells > 1 else metres
