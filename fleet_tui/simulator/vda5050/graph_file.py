"""The floors' graphs as files of LIF, one floor in each."""

import json
from pathlib import Path
from typing import Any

from fleet_tui.simulator.warehouse import SimFloor, build_building
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

_NODE = {"vehicleTypeNodeProperties": [{"vehicleTypeId": "simulated"}]}
_CHARGER = {
    "vehicleTypeNodeProperties": [
        {"vehicleTypeId": "simulated", "actions": [{"actionType": "startCharging"}]}
    ]
}
_EDGE = {"vehicleTypeEdgeProperties": [{"vehicleTypeId": "simulated"}]}


def write_lif(folder: Path, floors: int) -> list[Path]:
    """Write the graph of each floor into a folder, and return the files. Raises FleetError."""
    files = []
    try:
        for floor in build_building(floors).floors:
            files.append(folder / f"{floor.name}.lif.json")
            files[-1].write_text(json.dumps(lif_of(floor), indent=1) + "\n", encoding="utf-8")
    except OSError as error:
        raise FleetError(
            Message("cannot write {files}: {strerror}", files=files[-1], strerror=error.strerror)
        ) from error
    return files


def lif_of(floor: SimFloor) -> dict[str, Any]:
    """Return a floor's graph; every edge is listed twice, once per direction."""
    nodes = [
        {
            "nodeId": str(vertex.id),
            "nodeName": floor.labels.get(vertex.id, ""),
            "mapId": floor.name,
            "nodePosition": {"x": float(vertex.x), "y": float(vertex.y)},
            **(_CHARGER if floor.types.get(vertex.id) == "charger" else _NODE),
        }
        for vertex in floor.graph.vertices.values()
    ]
    ways = [(edge.start, edge.end) for edge in floor.graph.edges]
    edges = [
        {"edgeId": f"{a}-{b}", "startNodeId": str(a), "endNodeId": str(b), **_EDGE}
        for start, end in ways
        for a, b in ((start, end), (end, start))
    ]
    layout = {"layoutId": floor.name, "nodes": nodes, "edges": edges, "stations": []}
    return {"metaInformation": {"lifVersion": "1.0.0"}, "layouts": [layout]}
