"""Units of LIF files: metres and radians by the format, but some files have millimetres or degrees."""

import math
from typing import Any

from fleet_tui.errors import GraphError
from fleet_tui.graph_files.fields import Table
from fleet_tui.graph_files.graph_file import MissingChoiceError, ReadChoices

FARTHEST = 2000.0
"""Metres; a layout that extends farther has probably another unit."""
LENGTHS = {"m": 1.0, "mm": 0.001}
ANGLES = {"rad": 1.0, "deg": math.pi / 180}
_PLACES = ("nodePosition", "stationPosition", "controlPoints")


def in_si_units(tree: Table, choices: ReadChoices) -> tuple[Table, tuple[str, ...]]:
    """Return the contents of a file in metres and radians, with notes on doubtful units.

    Raises MissingChoiceError where `choices` wants to be asked and a unit is in doubt.
    """
    farthest, turn = _largest(tree)
    notes = list[str]()
    if farthest > FARTHEST and not choices.lengths:
        text = f"positions up to {farthest:g}: metres by the format, probably millimetres"
        _ask(choices, text, "--lengths", tuple(LENGTHS))
        notes.append(f"{text}; read as metres (--lengths mm for millimetres)")
    if turn > math.tau and not choices.angles:
        text = f"theta up to {turn:g}: radians by the format, probably degrees"
        _ask(choices, text, "--angles", tuple(ANGLES))
        notes.append(f"{text}; read as radians (--angles deg for degrees)")
    length, angle = LENGTHS.get(choices.lengths, 1.0), ANGLES.get(choices.angles, 1.0)
    if (length, angle) == (1.0, 1.0):
        return tree, tuple(notes)
    return _scaled(tree, length, angle, False, 0), tuple(notes)


def _ask(choices: ReadChoices, text: str, option: str, units: tuple[str, ...]) -> None:
    if choices.ask:
        raise MissingChoiceError(text, option, units)


def _largest(tree: Table) -> tuple[float, float]:
    """Return the largest x or y of a node, and the largest theta."""
    positions, turns = [0.0], [0.0]
    for layout in _list(tree.get("layouts")):
        for node in _list(_get(layout, "nodes")):
            position = _get(node, "nodePosition")
            positions += [abs(one) for one in (_get(position, "x"), _get(position, "y")) if _is_number(one)]
            thetas = [_get(entry, "theta") for entry in _list(_get(node, "vehicleTypeNodeProperties"))]
            turns += [abs(one) for one in thetas if _is_number(one)]
    return max(positions), max(turns)


def _get(value: Any, key: str) -> Any:
    return value.get(key) if isinstance(value, dict) else None


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _is_number(value: Any) -> bool:
    """Tell whether a value is a number of a size that a float can have."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e300


def _scaled(value: Any, length: float, angle: float, placed: bool, depth: int) -> Any:
    """Return a copy with the x and y of places, heights and thetas in metres and radians."""
    if depth > 100:
        raise GraphError("nested too deep")
    if isinstance(value, list):
        return [_scaled(one, length, angle, placed, depth + 1) for one in value]
    if not isinstance(value, dict):
        return value
    found = {}
    for key, one in value.items():
        if _is_number(one) and (key == "stationHeight" or (placed and key in ("x", "y"))):
            found[key] = one * length
        elif _is_number(one) and key == "theta":
            found[key] = one * angle
        else:
            found[key] = _scaled(one, length, angle, placed or key in _PLACES, depth + 1)
    return found
