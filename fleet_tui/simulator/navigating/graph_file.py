"""The floors' graphs as files, for kinds of robots without a topic of the graph: GeoJSON as Nav2's route
server reads it, one floor in each."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from fleet_tui.simulator.messages import FRAME
from fleet_tui.simulator.warehouse import SimFloor, build_building
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

Feature = dict[str, Any]


def write_graphs(path: Path, floors: int) -> list[Path]:
    """Write the graph of the only floor to the file `path`, or those of several into the folder `path`, each
    as its floor's name with `.geojson`; return the files. Raises FleetError."""
    building = build_building(floors)
    files = [path] if floors == 1 else [path / f"{floor.name}.geojson" for floor in building.floors]
    try:
        for floor, file in zip(building.floors, files, strict=True):
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(json.dumps(route_graph(floor), indent=1) + "\n", encoding="utf-8")
    except OSError as error:
        raise FleetError(
            Message(
                "cannot write {file}: {strerror}; choose another --graph-file",
                file=file,
                strerror=error.strerror,
            )
        ) from error
    return files


def route_graph(floor: SimFloor) -> Feature:
    """A floor's graph; every edge is listed twice, once per direction."""
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
