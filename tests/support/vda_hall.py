"""A hall with three nodes in a row, 2 m apart, as a LIF file."""

import json
from pathlib import Path

from fleet_tui.maps.route_graphs import load_floor_graph
from fleet_tui.model.events import FloorGraphLoaded

TYPE = {"vehicleTypeNodeProperties": [{"vehicleTypeId": "t"}]}
EDGE_TYPE = {"vehicleTypeEdgeProperties": [{"vehicleTypeId": "t"}]}
LIF = {
    "metaInformation": {"lifVersion": "1.0.0"},
    "layouts": [
        {
            "layoutId": "hall",
            "nodes": [
                {"nodeId": id_, "nodeName": name, "mapId": "hall", "nodePosition": {"x": x, "y": 0.0}, **TYPE}
                for id_, name, x in (("n0", "Base", 0.0), ("n1", "Rack", 2.0), ("n2", "Dock", 4.0))
            ],
            "edges": [
                {"edgeId": f"{a}-{b}", "startNodeId": a, "endNodeId": b, **EDGE_TYPE}
                for a, b in (("n0", "n1"), ("n1", "n2"))
            ],
            "stations": [],
        }
    ],
}


def hall_graph(folder: Path) -> FloorGraphLoaded:
    """The graph of the hall, read from a file in this folder."""
    file = folder / "hall.lif.json"
    file.write_text(json.dumps(LIF))
    return load_floor_graph("hall", file)
