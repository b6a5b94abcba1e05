"""Files with millimetres or degrees, which the format does not have."""

import math
from typing import Any

import pytest

from fleet_tui.maps.formats.graph_file import MissingChoiceError, ReadChoices
from fleet_tui.maps.formats.lif import in_si_units


def tree(x: float, theta: float) -> dict[str, Any]:
    entry = {"vehicleTypeId": "a", "theta": theta, "x": 5}
    node = {"nodePosition": {"x": x, "y": 1.0}, "vehicleTypeNodeProperties": [entry]}
    return {"layouts": [{"nodes": [node], "stations": [{"stationHeight": 1000}]}]}


def test_usual_values_are_left_alone() -> None:
    usual = tree(10.0, 3.0)
    found, notes = in_si_units(usual, ReadChoices(ask=True))
    assert found is usual and notes == ()


def test_doubtful_units_are_noted_or_asked() -> None:
    _, notes = in_si_units(tree(3500.0, 90.0), ReadChoices())
    assert [note.partition(":")[0] for note in notes] == ["positions up to 3500", "theta up to 90"]
    with pytest.raises(MissingChoiceError) as missing:
        in_si_units(tree(3500.0, 1.0), ReadChoices(ask=True))
    assert (missing.value.option, missing.value.choices) == ("--lengths", ("m", "mm"))
    with pytest.raises(MissingChoiceError, match="probably degrees"):
        in_si_units(tree(1.0, 90.0), ReadChoices(ask=True))


def test_other_units_are_converted() -> None:
    found, notes = in_si_units(tree(3500.0, 90.0), ReadChoices(lengths="mm", angles="deg", ask=True))
    layout = found["layouts"][0]
    assert notes == () and layout["nodes"][0]["nodePosition"] == {"x": 3.5, "y": 0.001}
    entry = layout["nodes"][0]["vehicleTypeNodeProperties"][0]
    assert math.isclose(entry["theta"], math.pi / 2) and entry["x"] == 5
    assert layout["stations"][0]["stationHeight"] == 1.0


def test_other_structures_are_no_concern_here() -> None:
    assert in_si_units(tree(10**400, 10**400), ReadChoices())[1] == ()
    assert in_si_units({"layouts": 7}, ReadChoices())[1] == ()
    assert in_si_units({"layouts": [7, {"nodes": [{"nodePosition": []}]}]}, ReadChoices())[1] == ()
