"""Robots that publish no graph: what a graph from a file is to the commands without a screen."""

import json
from collections.abc import Mapping
from pathlib import Path

import pytest

from fleet_tui.model.events import FloorGraphLoaded
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.records import EventRecord
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.simulator.warehouse import build_floor
from tests.support.cli import asked, config_file, run

MUTE = 'graph = ""\nlabels = ""\n'
NOWHERE = {"properties": {"id": 999, "startid": 0, "endid": 77}, "geometry": {"type": "LineString"}}


def write_routes(path: Path, *more: object) -> None:
    """The first floor's graph, each edge in both directions."""
    floor = build_floor(0)

    def feature(properties: Mapping[str, object], type_: str, *coordinates: float) -> object:
        return {"properties": properties, "geometry": {"type": type_, "coordinates": coordinates}}

    nodes = [
        feature({"id": one.id, "metadata": {"name": floor.labels.get(one.id)}}, "Point", one.x, one.y)
        for one in floor.graph.vertices.values()
    ]
    ways = [(edge.start, edge.end) for edge in floor.graph.edges]
    ways += [(end, start) for start, end in ways]
    edges = [
        feature({"id": 200 + n, "startid": a, "endid": b}, "LineString") for n, (a, b) in enumerate(ways)
    ]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [*nodes, *edges, *more]}))


@pytest.fixture
def site(server: RosbridgeServer, tmp_path: Path) -> Path:
    """A config for one robot that publishes no graph, and the file that has it."""
    config = config_file(tmp_path, server.url)
    text = config.read_text().replace('name = "floor_0"\n', 'name = "floor_0"\ngraph = "routes.geojson"\n')
    config.write_text(text + MUTE)
    write_routes(tmp_path / "routes.geojson")
    return tmp_path


async def test_an_order_by_the_labels_of_a_file(server: RosbridgeServer, site: Path) -> None:
    done = await run(site, "order", "robot_0", "Base", "Consumidores")
    assert (done.code, done.err) == (0, "")
    assert done.out.startswith("robot_0 order Base -> Consumidores: confirmed")
    assert asked(server) == ["robot_0 Execute_order"]
    topics = [one["topic"] for one in server.bridge.received if one["op"] == "subscribe"]
    assert topics and not any("graph" in topic or "labeled" in topic for topic in topics)


async def test_a_recording_has_it_once(site: Path) -> None:
    assert (await run(site, "record", "x.jsonl.gz", "--for", "1s")).code == 0
    told = [
        one.event for one in open_recording(site / "x.jsonl.gz").records() if isinstance(one, EventRecord)
    ]
    (loaded,) = [event for event in told if isinstance(event, FloorGraphLoaded)]
    assert loaded.graph is not None and loaded.labels["19"] == "Consumidores"


async def test_the_doctor_looks_at_the_file_as_at_a_robots_graph(site: Path) -> None:
    floor, fine = build_floor(0), await run(site, "doctor")
    said = " ".join(fine.out.split())
    assert fine.code == 0, said
    assert f"floor_0 graph file: routes.geojson: 20 vertices, {len(floor.labels)} labels" in said
    assert f"floor_0 graph: {len(floor.graph.edges)} edges by routes.geojson, all vertices reachable" in said
    write_routes(site / "routes.geojson", NOWHERE)
    done = await run(site, "doctor")
    said = " ".join(done.out.split())
    assert done.code == 0 and "warn" in said
    assert "graph routes.geojson: edge 999 names unknown vertex 77: left out -> correct the file" in said
