"""The floors' graphs as files, one floor in each, for kinds of robots without a topic of the graph: GeoJSON
as Nav2's route server reads it, and LIF."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from fleet_tui.simulator.messages import FRAME
from fleet_tui.simulator.warehouse import SimFloor, build_building
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

Feature = dict[str, Any]

_NODE = {"vehicleTypeNodeProperties": [{"vehicleTypeId": "simulated"}]}
_CHARGER = {
    "vehicleTypeNodeProperties": [
        {"vehicleTypeId": "simulated", "actions": [{"actionType": "startCharging"}]}
    ]
}
_EDGE = {"vehicleTypeEdgeProperties": [{"vehicleTypeId": "simulated"}]}


def write_graphs(path: Path, floors: int) -> list[Path]:
    """Write GeoJSON of the only floor to the file `path`, or that of several into the folder `path`, each as
    its floor's name with `.geojson`; return the files. Raises FleetError."""
    building = build_building(floors)
    files = [path] if floors == 1 else [path / f"{floor.name}.geojson" for floor in building.floors]
    for floor, file in zip(building.floors, files, strict=True):
        _write(file, route_graph(floor))
    return files


def write_lif(folder: Path, floors: int) -> list[Path]:
    """Write LIF of each floor into a folder, and return the files. Raises FleetError."""
    building = build_building(floors)
    files = [folder / f"{floor.name}.lif.json" for floor in building.floors]
    for floor, file in zip(building.floors, files, strict=True):
        _write(file, lif_of(floor))
    return files


def _write(file: Path, value: dict[str, Any]) -> None:
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")
    except OSError as error:
        raise FleetError(
            Message(
                "cannot write {file}: {strerror}; choose another --graph-file",
                file=file,
                strerror=error.strerror,
            )
        ) from error


def route_graph(floor: SimFloor) -> Feature:
    """A floor's graph as GeoJSON; every edge is listed twice, once per direction."""
    return {
        "type": "FeatureCollection",
        "name": floor.name,
        "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}},
        "features": [*_nodes(floor), *_edges(floor)],
    }


def _nodes(floor: SimFloor) -> Iterator[Feature]:
    for vertex in floor.graph.vertices.values():
        metadata = {"class": floor.types[vertex.id]}
        if vertex.id in floor.labels:
            metadata["name"] = floor.labels[vertex.id]
        properties = {"id": vertex.id, "frame": FRAME, "metadata": metadata}
        # A number's spelling is its type there: a coordinate needs its point.
        yield _feature(properties, "Point", [float(vertex.x), float(vertex.y)])


def _edges(floor: SimFloor) -> Iterator[Feature]:
    """Nodes and edges share one sequence of ids."""
    spots = floor.graph.vertices
    id_ = max(spots)
    for edge in floor.graph.edges:
        for start, end in ((edge.start, edge.end), (edge.end, edge.start)):
            id_ += 1
            line = [[float(spots[one].x), float(spots[one].y)] for one in (start, end)]
            yield _feature({"id": id_, "startid": start, "endid": end}, "MultiLineString", [line])


def _feature(properties: Feature, type_: str, coordinates: list[Any]) -> Feature:
    geometry = {"type": type_, "coordinates": coordinates}
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def lif_of(floor: SimFloor) -> dict[str, Any]:
    """A floor's graph as LIF; every edge is listed twice, once per direction."""
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
