"""The console reads the graphs that are written for simulated vehicles."""

from pathlib import Path

import pytest

from fleet_tui.maps.route_graphs import load_floor_graph
from fleet_tui.simulator.graph_files import write_lif
from fleet_tui.text.errors import FleetError


def test_the_graph_of_each_floor_is_a_file_of_lif(tmp_path: Path) -> None:
    files = write_lif(tmp_path, 2)
    assert [file.name for file in files] == ["floor_0.lif.json", "floor_1.lif.json"]
    loaded = load_floor_graph("floor_0", files[0])
    assert loaded.graph is not None and loaded.labels["0"] == "Base" and not loaded.problem
    assert loaded.graph.path("0", "19")
    assert [loaded.labels[charger.id] for charger in loaded.graph.chargers] == ["Charger"]
    with pytest.raises(FleetError, match="cannot write"):
        write_lif(files[0] / "below", 1)
