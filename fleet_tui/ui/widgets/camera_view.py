"""The picture of a robot's camera, below a line about it."""

from collections.abc import Mapping
from functools import lru_cache
from textwrap import wrap
from typing import ClassVar

import numpy as np
from rich.color import Color
from rich.style import Style
from textual.geometry import Region
from textual.strip import Strip

from fleet_tui.ui.terminal.cell_strip import CellStrip
from fleet_tui.ui.view.camera.cells import PictureCells
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run
from fleet_tui.ui.widgets.runs_view import RunsView

CAPTION_ROWS = 1


class CameraView(RunsView, can_focus=True):
    """Shows a picture in the middle, or a note in its place."""

    DEFAULT_CSS: ClassVar[str] = "CameraView { width: 1fr; height: 1fr; display: none; }"

    def __init__(self) -> None:
        super().__init__(id="camera")
        self._made_of: tuple[PictureCells | None, str, tuple[int, int]] | None = None
        self._body = Cells.blank(0, 0, StyleRole.TEXT)
        self._colours: list[Style] = []

    @property
    def space(self) -> tuple[int, int]:
        """Return the pixels of the largest picture: width and height."""
        return self.size.width, 2 * (self.size.height - CAPTION_ROWS)

    def set_role_styles(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change the theme; the picture is painted again with the next one."""
        self._made_of = None
        super().set_role_styles(styles)

    def show(self, heading: Run, note: str, picture: PictureCells | None, rule: str = "─") -> None:
        """Show a picture, or without one a note. Only what changed is painted. `rule`: the character of the
        caption's line."""
        width, height = self.size
        if width < 1 or height <= CAPTION_ROWS:
            return
        caption = self._caption(heading, width, rule)
        made_of = picture, note, (width, height)
        changed = range(0)
        if not self._is_made_of(made_of):
            self._made_of = made_of
            self._body, colours = _body(picture, note, width, height - CAPTION_ROWS)
            self._colours = [self._styles[StyleRole.TEXT], *map(_style, colours)]
            changed = range(height)
        elif [caption] != self._rows:
            changed = range(CAPTION_ROWS)
        self._rows = [caption]
        self._renew(changed, height)
        if changed:
            self.refresh(*(Region(0, y, width, 1) for y in changed))

    def _is_made_of(self, made_of: tuple[PictureCells | None, str, tuple[int, int]]) -> bool:
        before = self._made_of
        return before is not None and before[0] is made_of[0] and before[1:] == made_of[1:]

    def _caption(self, heading: Run, width: int, rule: str) -> list[Run]:
        text, role = heading
        cells = Cells.blank(width, 1, StyleRole.ACCENT if self.has_focus else StyleRole.RULE)
        cells.codes[:] = ord(rule)
        cells.write(1, 0, f" {text} ", role)
        return [(part, StyleRole(number)) for part, number in cells.runs(0)]

    def _strip(self, y: int) -> Strip:
        if y < CAPTION_ROWS:
            return super()._strip(y)
        return CellStrip(self._body, y - CAPTION_ROWS, self._colours)


def _body(picture: PictureCells | None, note: str, width: int, height: int) -> tuple[Cells, list[int]]:
    """Return the cells below the caption, and the pairs of colours by their numbers from 1 on."""
    blank = Cells.blank(width, height, StyleRole.FLOOR)
    body = Cells(blank.codes, np.zeros((height, width), np.uint16))
    if picture is None:
        lines = wrap(note, width)[:height]
        for n, line in enumerate(lines, height // 2 - len(lines) // 2):
            body.write((width - len(line)) // 2, n, line, StyleRole.FLOOR)
        return body, []
    codes = picture.codes[:height, :width]
    lines, columns = codes.shape
    top, left = (height - lines) // 2, (width - columns) // 2
    middle = slice(top, top + lines), slice(left, left + columns)
    body.codes[middle] = codes
    if picture.colours is None:
        return body, []
    shown = picture.colours[:height, :width].astype(np.uint16)
    pairs, numbers = np.unique(shown[..., 0] << 8 | shown[..., 1], return_inverse=True)
    body.roles[middle] = numbers.reshape(lines, columns) + 1
    return body, pairs.tolist()


@lru_cache(8192)
def _style(pair: int) -> Style:
    """Return the style of the number of an upper colour, times 256, and that of a lower one."""
    return Style(color=Color.from_ansi(pair >> 8), bgcolor=Color.from_ansi(pair & 0xFF))
