"""A measured figure, the same for every benchmark: printed where it is made, listed at the end."""

import statistics
from collections.abc import Iterable, Sequence
from typing import TypedDict


class Row(TypedDict):
    """`target` is the most that `figure` may be, None where there is only something to compare with.
    `ratio` is figure / the same of what `against` names."""

    id: str
    what: str
    figure: float
    unit: str
    target: float | None
    ratio: float | None
    against: str


def row(
    id_: str,
    what: str,
    figure: float,
    unit: str,
    target: float | None = None,
    other: float | None = None,
    against: str = "",
) -> Row:
    """A row, printed; `other` is the figure of `against`."""
    named = f"{against}: {number(other)} {unit}".rstrip() if other is not None else against
    made = Row(
        id=id_,
        what=what,
        figure=figure,
        unit=unit,
        target=target,
        ratio=figure / other if other else None,
        against=named,
    )
    print(line(made), flush=True)
    return made


def times_source(
    id_: str, what: str, ours: tuple[float, float], source: tuple[float, float], against: str, most: float
) -> list[Row]:
    """Rows of the per cent of a core of screen thread and process, beside those with the source's robots;
    `most`: the target of the times that the process may take."""
    return [
        row(id_, f"{what}: screen thread", ours[0], "%", None, source[0], against),
        row(id_, f"{what}: process", ours[1], "%", None, source[1], against),
        row(id_, f"{what}: process, times that of {against}", ours[1] / source[1], "x", most),
    ]


def number(value: float | None) -> str:
    if value is None:
        return "-"
    return f"{value:.0f}" if abs(value) >= 100 or value == int(value) else f"{value:.3g}"


def held(made: Row) -> bool:
    return made["target"] is None or made["figure"] <= made["target"]


def line(made: Row) -> str:
    verdict = "" if made["target"] is None else "held" if held(made) else "NOT held"
    target = "" if made["target"] is None else f"<= {number(made['target'])}"
    ratio = "" if made["ratio"] is None else f"{number(made['ratio'])} x"
    figure = f"{number(made['figure'])} {made['unit']}"
    return f"{made['id']:4}{made['what']:58}{figure:>13} {target:>9} {verdict:9}{ratio:>8} {made['against']}"


def table(rows: Iterable[Row]) -> str:
    head = f"{'id':4}{'what':58}{'figure':>13} {'target':>9} {'':9}{'ratio':>8} against"
    return "\n".join([head, "-" * len(head), *map(line, rows)])


def p95(values: Sequence[float]) -> float:
    return statistics.quantiles(values, n=20)[-1]
