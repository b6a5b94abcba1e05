"""Missing options: asked on a terminal, named elsewhere."""

import click
import pytest

from fleet_tui.features.graphs.cli.answers import GraphAnswers, answered
from fleet_tui.maps.formats.graph_file import MissingChoiceError
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message


def make(given: GraphAnswers) -> str:
    if given.building_graph is None:
        raise MissingChoiceError(Message("several graphs"), "--building-graph", ("0", "3"))
    if not given.vehicle_type:
        raise MissingChoiceError(Message("a vehicle type"), "--vehicle-type")
    return f"{given.building_graph} {given.vehicle_type}"


def test_asked_one_after_the_other(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def prompt(text: str, **_: object) -> object:
        asked.append(text)
        return 3 if "graph" in text.splitlines()[-1] else "agv"

    monkeypatch.setattr(click, "prompt", prompt)
    made, answers = answered(make, GraphAnswers(is_terminal=True))
    assert made == "3 agv" and (answers.building_graph, answers.vehicle_type) == (3, "agv")
    assert asked == ["several graphs\n--building-graph", "a vehicle type\n--vehicle-type"]


def test_named_elsewhere() -> None:
    with pytest.raises(GraphError, match="several graphs: --building-graph is missing"):
        answered(make, GraphAnswers())
