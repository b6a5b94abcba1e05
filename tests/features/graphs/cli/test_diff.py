"""`graph diff`: changes by id."""

from pathlib import Path

from msgspec.structs import replace

from fleet_tui.model.graphs.document import DocumentFloor, GraphFormat
from tests.support.cli import run
from tests.support.graph_files import sample, write_text


async def test_changes_and_their_numbers(tmp_path: Path) -> None:
    floor = sample().floors["ground"]
    moved = replace(floor.vertices["1"], x=4.5)
    other = sample().with_floor(replace(floor, vertices={**floor.vertices, "1": moved}))
    (tmp_path / "a.yaml").write_text(write_text(sample(), GraphFormat.NATIVE))
    (tmp_path / "b.geojson").write_text(write_text(other, GraphFormat.GEOJSON))
    done = await run(tmp_path, "graph", "diff", "a.yaml", "b.geojson")
    assert (done.code, done.out) == (1, "moved: vertex 1 (007): 0.50 m\n1 moved\n")
    done = await run(tmp_path, "graph", "diff", "a.yaml", "a.yaml")
    assert (done.code, done.out) == (0, "no difference\n")
    assert (await run(tmp_path, "graph", "diff", "a.yaml", "gone")).code == 2


async def test_floors_by_their_names(tmp_path: Path) -> None:
    (tmp_path / "a").write_text(write_text(sample(), GraphFormat.NATIVE))
    upper = sample().with_floor(DocumentFloor("upper"))
    (tmp_path / "b").write_text(write_text(upper, GraphFormat.NATIVE))
    done = await run(tmp_path, "graph", "diff", "a", "b")
    assert (done.code, done.out) == (1, "added: floor upper\n1 added\n")
