"""The graph files, and the command line of robots that need them."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.simulator.graph_files import write_graphs
from fleet_tui.simulator.warehouse import build_floor
from fleet_tui.text.errors import FleetError
from tests.support.command_line import run


def features(file: Path, type_: str) -> list[dict[str, Any]]:
    found = json.loads(file.read_text())["features"]
    return [one for one in found if one["geometry"]["type"] == type_]


def test_a_file_holds_the_floors_graph(tmp_path: Path) -> None:
    (file,) = write_graphs(tmp_path / "graph.geojson", 1)
    floor = build_floor(0)
    nodes, edges = features(file, "Point"), features(file, "MultiLineString")
    assert {node["properties"]["id"]: tuple(node["geometry"]["coordinates"]) for node in nodes} == {
        id_: (vertex.x, vertex.y) for id_, vertex in floor.graph.vertices.items()
    }
    named = {one["properties"]["id"]: one["properties"]["metadata"].get("name") for one in nodes}
    assert {id_: name for id_, name in named.items() if name} == floor.labels
    assert {one["properties"]["frame"] for one in nodes} == {"map"}
    ways = {(one["properties"]["startid"], one["properties"]["endid"]) for one in edges}
    there = {(edge.start, edge.end) for edge in floor.graph.edges}
    assert ways == there | {(end, start) for start, end in there}
    ids = [one["properties"]["id"] for one in (*nodes, *edges)]
    assert len(set(ids)) == len(ids) and all(0 <= id_ < 65536 for id_ in ids)
    spelled = file.read_text().split('"coordinates": [')[1].split("]")[0]
    assert all("." in number for number in spelled.split(","))  # an integer is not read as a float there


def test_several_floors_are_a_folder_of_files(tmp_path: Path) -> None:
    files = write_graphs(tmp_path / "graphs", 2)
    assert [file.name for file in files] == ["floor_0.geojson", "floor_1.geojson"]
    assert len({one["properties"]["id"] for file in files for one in features(file, "Point")}) == 40


def test_a_file_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("")
    with pytest.raises(FleetError, match=r"cannot write .*taken.*: "):
        write_graphs(tmp_path / "taken" / "graph.geojson", 1)


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (("--kind", "nav"), "did you mean nav2?"),
        (("--kind", "nav2", "--ros", "1"), "kind nav2 runs on ROS 2 only"),
        (("--kind", "move_base", "--ros", "2"), "kind move_base runs on ROS 1 only"),
        (("--kind", "move_base", "--fault", "inactive"), "unknown fault"),
        (("--kind", "nav2", "--fault", "lots"), "did you mean lost?"),
        (("--kind", "nav2", "--fault", "refuse"), "unknown fault of this kind of robots"),
        (("--graph-file", "x.geojson"), "publish their graph"),
    ],
)
def test_what_makes_no_sense_is_a_usage_error(tmp_path: Path, args: tuple[str, ...], words: str) -> None:
    done = run("sim", "--port", "0", *args, cwd=tmp_path)
    assert done.returncode == 2 and words in done.stderr and "Traceback" not in done.stderr


def test_sim_writes_the_file_and_serves(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "fleet_tui", "sim", "--port", "0", "--kind", "nav2", "--stop-with-stdin"]
    command += ["--floors", "1", "--graph-file", "graph.geojson", "--fault", "lost:robot_1,humble"]
    with subprocess.Popen(
        command, cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as child:
        assert child.stdout is not None and child.stdin is not None
        assert child.stdout.readline().startswith("ws://127.0.0.1:")
        child.stdin.close()
        assert child.wait(10) == 0
    assert features(tmp_path / "graph.geojson", "Point")
