"""The same map drawn with what a user would otherwise pick. Only there where it is installed.

Each is given the map already sampled to its own dots (numpy slicing takes 0.1 ms), so that it is
timed for nothing but drawing. `pip install fleet-tui[bench]` brings all but chafa.
"""

import importlib
import io
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from rich.console import Console

from fleet_tui.model.occupancy import OCCUPIED, Classes

Draw = Callable[[], object]
GREYS = np.array([128, 255, 0], np.uint8)
"""Unknown, free, occupied."""


def sampled(level: Classes, width: int, height: int) -> Classes:
    """The nearest neighbours of a grid of dots over the whole map."""
    rows = np.arange(height) * level.shape[0] // height
    columns = np.arange(width) * level.shape[1] // width
    return level[np.ix_(rows, columns)]


def drawille(level: Classes, width: int, height: int) -> Draw:
    """Braille, 2 x 4 dots to a cell, no colour."""
    module: Any = importlib.import_module("drawille")
    dots = sampled(level, width * 2, height * 4) == OCCUPIED

    def draw() -> str:
        canvas = module.Canvas()
        for y, x in np.argwhere(dots).tolist():
            canvas.set(x, y)
        return str(canvas.frame())

    return draw


def rich_pixels(level: Classes, width: int, height: int) -> Draw:
    """Half blocks in colour, through Rich to the bytes."""
    module: Any = importlib.import_module("rich_pixels")
    image = _image(sampled(level, width, height * 2))
    console = Console(
        file=io.StringIO(), width=width, height=height, force_terminal=True, color_system="truecolor"
    )

    def draw() -> None:
        console.print(module.Pixels.from_image(image))

    return draw


def textual_canvas(level: Classes, width: int, height: int) -> Draw:
    """Half blocks in colour, as the rows that Textual paints."""
    module: Any = importlib.import_module("textual_canvas")
    color: Any = importlib.import_module("textual.color")
    colours = [color.Color(grey, grey, grey) for grey in GREYS.tolist()]
    dots = sampled(level, width, height * 2).tolist()

    def draw() -> list[object]:
        canvas = module.Canvas(width, height * 2, colours[0])
        with canvas.batch_refresh():
            for y, row in enumerate(dots):
                for x, kind in enumerate(row):
                    canvas.set_pixel(x, y, colours[kind])
        return [
            [canvas._segment_of(top, low) for top, low in zip(*canvas._canvas[y : y + 2], strict=True)]
            for y in range(0, height * 2, 2)
        ]

    return draw


def chafa(level: Classes, width: int, height: int) -> Draw:
    """The whole process, from a picture of four times its dots."""
    program = shutil.which("chafa")
    if program is None:
        raise ImportError("chafa is not on the PATH")
    path = Path(tempfile.mkdtemp()) / "map.png"
    _image(sampled(level, width * 8, height * 16)).save(path)
    command = [program, "--format=symbols", "--animate=off", f"--size={width}x{height}", str(path)]
    return lambda: subprocess.run(command, stdout=subprocess.DEVNULL, check=True)


def _image(classes: NDArray[np.uint8]) -> Image.Image:
    return Image.fromarray(GREYS[classes]).convert("RGB")


def others(level: Classes, width: int, height: int) -> Iterator[tuple[str, Draw]]:
    """The others that are installed, with the work to be timed; a word for each that is not."""
    for make in (drawille, rich_pixels, textual_canvas, chafa):
        try:
            yield make.__name__.replace("_", "-"), make(level, width, height)
        except ImportError as problem:
            print(f"P1  without {make.__name__.replace('_', '-')}: {problem}")
