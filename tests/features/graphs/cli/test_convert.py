"""`graph convert`: what is lost is said first, and the old file is kept."""

import json
from pathlib import Path

import pytest

from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphFormat, of_floor
from tests.support.cli import Ended, run
from tests.support.graph_files import line_graph, read_text, sample, write_text

BUILDING = """
coordinate_system: reference_image
levels:
  L1:
    vertices: [[0, 0, 0, a], [1, 1, 0, b], [2, 2, 0, c]]
    lanes: [[0, 1, {graph_idx: [2, 0]}], [1, 2, {graph_idx: [2, 1]}]]
    walls: [[0, 1, {}]]
"""


async def convert(folder: Path, *args: str) -> Ended:
    return await run(folder, "graph", "convert", *args)


async def test_losses_are_counted_on_stderr(tmp_path: Path) -> None:
    (tmp_path / "site.yaml").write_text(write_text(sample(), GraphFormat.NATIVE))
    done = await convert(tmp_path, "site.yaml", "out.geojson")
    assert done.code == 0
    assert done.out == "out.geojson: geojson, 1 floor, 4 vertices, 4 edges, 3 labels\n"
    assert done.err.splitlines() == [
        "lost: headings: 1",
        "lost: speeds in per cent: 1",
        "lost: curves: 1",
        "lost: lifts: 1",
        "lost: stations: 1",
        "lost: map files: 1",
    ]
    assert read_text((tmp_path / "out.geojson").read_text()).format is GraphFormat.GEOJSON


async def test_an_existing_file_is_kept_and_tells_the_format(tmp_path: Path) -> None:
    text = write_text(sample(), GraphFormat.NATIVE)
    (tmp_path / "x.yaml").write_text(f"# by hand\n{text}")
    done = await convert(tmp_path, "x.yaml", "x.yaml")
    assert (done.code, done.err) == (0, "") and done.out.endswith("; the old file is x.yaml.bak\n")
    assert (tmp_path / "x.yaml").read_text() == text
    assert (tmp_path / "x.yaml.bak").read_text().startswith("# by hand")


async def test_what_is_missing_is_named(tmp_path: Path) -> None:
    (tmp_path / "b.building.yaml").write_text(BUILDING)
    (tmp_path / "s.yaml").write_text(write_text(sample(), GraphFormat.NATIVE))
    two = sample().with_floor(DocumentFloor("upper"))
    (tmp_path / "two.yaml").write_text(write_text(two, GraphFormat.NATIVE))
    for args, option in (
        (("b.building.yaml", "o.geojson"), "--building-graph is missing"),
        (("s.yaml", "o.lif.json"), "--vehicle-type is missing"),
        (("s.yaml", "o.yaml"), "--to is missing"),
        (("two.yaml", "o.geojson"), "--floor is missing"),
    ):
        done = await convert(tmp_path, *args)
        assert done.code == 2 and option in done.err and "Traceback" not in done.err
        assert not (tmp_path / args[1]).exists()
    done = await convert(tmp_path, "b.building.yaml", "o.geojson", "--building-graph", "1")
    assert done.code == 0 and "not read: walls: 1" in done.err
    assert (await convert(tmp_path, "s.yaml", "o.lif.json", "--vehicle-type", "agv")).code == 0
    assert (await convert(tmp_path, "two.yaml", "f.geojson", "--floor", "ground")).code == 0
    assert (await convert(tmp_path, "s.yaml", "o.yaml", "--to", "oh")).code == 0


async def test_floors_are_named_by_the_file_or_the_option(tmp_path: Path) -> None:
    (tmp_path / "hall.v2.yaml").write_text(write_text(sample(), GraphFormat.OH))
    for args, name in (((), "hall"), (("--floor", "L1"), "L1")):
        assert (await convert(tmp_path, "hall.v2.yaml", "o.yaml", "--to", "rmf", *args)).code == 0
        assert list(read_text((tmp_path / "o.yaml").read_text()).document.floors) == [name]
    done = await convert(tmp_path, "o.yaml", "p.geojson", "--floor", "L2")
    assert done.code == 2 and "no floor 'L2'; it has L1" in done.err


async def test_what_the_format_refuses_is_not_written(tmp_path: Path) -> None:
    alone = of_floor(DocumentFloor("f", {"1": DocumentVertex("1", 0.0, 0.0)}))
    (tmp_path / "a.yaml").write_text(write_text(alone, GraphFormat.NATIVE))
    done = await convert(tmp_path, "a.yaml", "o.geojson")
    assert (done.code, done.out) == (1, "") and not (tmp_path / "o.geojson").exists()
    assert (
        done.err
        == "error: no edge: Nav2 does not load such a graph\nnot written: geojson refuses the graph\n"
    )
    nowhere = line_graph((0.0, 0.0), (float("nan"), 0.0))
    (tmp_path / "n.yaml").write_text(write_text(nowhere, GraphFormat.NATIVE))
    done = await convert(tmp_path, "n.yaml", "o.geojson")
    assert done.code == 2 and "vertex 2 on f: x or y is not finite: correct it first" in done.err


@pytest.mark.parametrize(
    ("target", "said"),
    [
        (".", "no format is known for"),
        ("no/o.geojson", "no/o.geojson: cannot be written: No such file or directory"),
        ("o.xml", "opentcs can be read, not written"),
        ("folder.geojson", "folder.geojson: is a folder"),
    ],
)
async def test_where_it_cannot_be_written(tmp_path: Path, target: str, said: str) -> None:
    (tmp_path / "s.yaml").write_text(write_text(sample(), GraphFormat.NATIVE))
    (tmp_path / "folder.geojson").mkdir()
    done = await convert(tmp_path, "s.yaml", target)
    assert done.code == 2 and said in done.err and "Traceback" not in done.err


async def test_units_of_lif(tmp_path: Path) -> None:
    node = {"nodeId": "n", "nodePosition": {"x": 5000, "y": 0}, "vehicleTypeNodeProperties": []}
    layout = {"layoutId": "L", "layoutVersion": "1", "nodes": [node], "edges": [], "stations": []}
    (tmp_path / "a.lif.json").write_text(json.dumps({"layouts": [layout]}))
    done = await convert(tmp_path, "a.lif.json", "o.yaml", "--to", "rmf")
    assert done.code == 0 and "positions up to 5000: metres by the format, probably millimetres" in done.err
    done = await convert(tmp_path, "a.lif.json", "o.yaml", "--lengths", "mm")
    assert read_text((tmp_path / "o.yaml").read_text()).document.floors["L"].vertices["0"].x == 5.0
