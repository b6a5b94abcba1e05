"""What a pane shows: a title and rows of runs, with buttons where the mouse can press."""

from collections.abc import Hashable, Iterable
from dataclasses import dataclass

from fleet_tui.view.roles import Ink
from fleet_tui.view.text import cell_width, fit

Run = tuple[str, Ink]


@dataclass(frozen=True, slots=True)
class Button:
    """Something to press in the cells from `start` to before `end` of a row."""

    start: int
    end: int
    name: str


@dataclass(frozen=True, slots=True)
class Row:
    """One row. `key` says whose it is, so that the cursor stays with it when rows move."""

    key: Hashable
    runs: tuple[Run, ...]
    buttons: tuple[Button, ...] = ()


@dataclass(frozen=True, slots=True)
class Table:
    """A pane at one moment. `empty` stands where there is no row."""

    title: tuple[Run, ...]
    rows: tuple[Row, ...]
    empty: str = ""
    title_buttons: tuple[Button, ...] = ()


def width_of(runs: Iterable[Run]) -> int:
    """The cells that runs take."""
    return sum(cell_width(text) for text, _ in runs)


def cut(runs: Iterable[Run], cells: int) -> tuple[Run, ...]:
    """Runs in exactly `cells` cells: cut with an ellipsis or padded."""
    result: list[Run] = []
    left = cells
    for text, ink in runs:
        if left <= 0:
            break
        width = cell_width(text)
        if width > left:
            text, width = fit(text, left), left
        result.append((text, ink))
        left -= width
    if left > 0:
        result.append((" " * left, Ink.TEXT))
    return tuple(result)


def column(texts: Iterable[str], at_least: int = 0, at_most: int = 24) -> int:
    """The width of a column that holds these texts: it doesn't dance when values change."""
    return max(at_least, min(at_most, max(map(cell_width, texts), default=0)))
