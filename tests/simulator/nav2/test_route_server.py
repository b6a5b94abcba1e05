"""Route servers: the graphs that they take from files, and the files that they refuse."""

import os
from pathlib import Path

import pytest

from fleet_tui.simulator.graph_files import write_graphs
from fleet_tui.simulator.nav2 import fleet
from fleet_tui.simulator.nav2.fleet import RouteServers

POINT = '{"properties": {"id": 1}, "geometry": {"type": "Point", "coordinates": [1.0, 2.0]}}'


def line(end: object) -> str:
    ends = f'{{"id": 9, "startid": 1, "endid": {end}}}'
    return f'{{"properties": {ends}, "geometry": {{"type": "LineString", "coordinates": []}}}}'


def collection(*features: str) -> str:
    return f'{{"type": "FeatureCollection", "features": [{", ".join(features)}]}}'


def test_a_file_of_the_simulator_is_taken(tmp_path: Path) -> None:
    (file,) = write_graphs(tmp_path / "a graph's {file}.geojson", 1)
    servers = RouteServers()
    assert servers.load("robot_0", str(file))
    taken = servers.graphs["robot_0"]
    assert taken.path == str(file) and len(taken.vertices) == 20 and len(taken.edges) == 52


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{}",
        "[" * 100_000,
        "\udcff",
        collection(),
        collection(POINT),
        collection(line(1)),
        collection(POINT, line(2)),
        collection(POINT, line("true")),
        collection(POINT, '{"properties": {}, "geometry": null}'),
        collection(POINT, line(1)) + "x",
    ],
)
def test_a_bad_file_leaves_the_graph_before_in_use(tmp_path: Path, text: str) -> None:
    servers = RouteServers()
    good, bad = tmp_path / "good.geojson", tmp_path / "bad.geojson"
    good.write_text(collection(POINT, line(1)))
    bad.write_bytes(text.encode(errors="surrogateescape"))
    assert servers.load("robot_0", str(good)) and not servers.load("robot_0", str(bad))
    assert servers.graphs["robot_0"].path == str(good)


def test_a_missing_file_a_pipe_and_a_large_one_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    servers, pipe, large = RouteServers(), tmp_path / "pipe", tmp_path / "large.geojson"
    os.mkfifo(pipe)
    large.write_text(collection(POINT, line(1)))
    monkeypatch.setattr(fleet, "LARGEST", 50)
    found = [servers.load("robot_0", str(path)) for path in (tmp_path / "none", tmp_path, pipe, large, "\0")]
    assert not any(found) and not servers.graphs
