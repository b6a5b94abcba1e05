"""The draft of a graph as a file."""

from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.maps.formats.graph_file import ReadChoices, WriteChoices
from fleet_tui.maps.formats.writing import write_graph
from fleet_tui.maps.graph_storage import load_graph_file
from fleet_tui.model.graphs.document import (
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    of_floor,
)
from tests.support.drawn_graph import DrawnGraph, drawn_graph


def read(path: Path) -> tuple[GraphFormat, GraphDocument]:
    file = load_graph_file(path, None, ReadChoices("floor_0"))
    return file.format, file.document


def said_yes(it: DrawnGraph) -> int:
    count = len(it.desk.answers)
    it.desk.say_yes()
    it.desk.answers.clear()
    return count


@pytest.mark.parametrize(
    ("line", "format_"),
    [
        ("write a.yaml", GraphFormat.NATIVE),
        ("write a.yaml oh", GraphFormat.OH),
        ("write a.yaml rmf", GraphFormat.RMF),
        ("write a.geojson", GraphFormat.GEOJSON),
        ("write a.lif.json lif AMR", GraphFormat.LIF),
    ],
)
async def test_it_is_written_by_name_in_every_format(line: str, format_: GraphFormat, tmp_path: Path) -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.typed(line.replace("write ", f"write {tmp_path}/"))
        said_yes(it)
        (path,) = tmp_path.iterdir()  # noqa: ASYNC240  # the loop has nothing else to do
        found, document = read(path)
        assert found is format_
        (floor,) = document.floors.values()
        assert sorted(floor.labels.values()) == ["Base", "Store"]
        assert f"{path.name}: {format_.value}, 2 vertices" in it.desk.notices.text


async def test_the_floors_own_file_is_replaced_after_a_question_and_kept_beside(tmp_path: Path) -> None:
    path = tmp_path / "site.yaml"
    async with drawn_graph() as it:
        it.editor.start()
        it.typed(f"write {path}")
        said_yes(it)
        before = path.read_bytes()
        it.graph_file = path
        it.at((9.0, 9.0))
        it.drawing.add_at_cursor()
        it.files.write()
        assert path.read_bytes() == before
        assert said_yes(it) == 1
        assert len(read(path)[1].floors["floor_0"].vertices) == 3
        assert (tmp_path / "site.yaml.bak").read_bytes() == before


async def test_without_a_file_a_name_is_asked_and_other_floors_of_a_file_stay(tmp_path: Path) -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.files.write()
        assert it.desk.begun == ["write floor_0.yaml"]
        path = tmp_path / "site.yaml"
        it.typed(f"write {path}")
        said_yes(it)
        other = DocumentFloor("floor_1", {"7": DocumentVertex("7", 1.0, 2.0, "Attic")})
        path.write_text(write_graph(read(path)[1].with_floor(other), GraphFormat.NATIVE, WriteChoices()))
        it.typed(f"write {path}")
        said_yes(it)
        assert set(read(path)[1].floors) == {"floor_0", "floor_1"}


@pytest.mark.parametrize(
    ("line", "said"), [("write", "a file, then a format"), ("write a.yaml rfm", "did you mean rmf")]
)
async def test_a_line_says_what_it_lacks(line: str, said: str) -> None:
    async with drawn_graph() as it:
        it.editor.start()
        typed = it.files.typed(line)
        assert typed is not None and said in typed.problem


async def test_what_cannot_be_written_is_said(tmp_path: Path) -> None:
    async with drawn_graph() as it:
        it.editor.start()
        for line, said in ((f"write {tmp_path}", "is a folder"), (f"write {tmp_path}/a.lif.json", "vehicle")):
            it.typed(line)
            said_yes(it)
            assert said in it.desk.notices.text.lower()
        (tmp_path / "broken.yaml").write_text("{]")
        it.typed(f"write {tmp_path}/broken.yaml")
        assert said_yes(it) == 1
        assert (tmp_path / "broken.yaml.bak").read_text() == "{]"


async def test_what_robots_do_not_report_stays_in_the_file(tmp_path: Path) -> None:
    path = tmp_path / "site.yaml"
    async with drawn_graph() as it:
        it.editor.start()
        live = it.floor
        (edge,) = live.edges.values()
        fast = replace(live, edges={edge.id: replace(edge, speed=0.7, cost=3.0)}, to_site=(1.0, 2.0, 0.0))
        path.write_text(write_graph(of_floor(fast), GraphFormat.NATIVE, WriteChoices()))
        it.at((9.0, 9.0))
        it.drawing.add_at_cursor()
        it.mode.edge = edge.id
        it.typed("cost 2")
        it.typed(f"write {path}")
        said_yes(it)
        floor = read(path)[1].floors["floor_0"]
        assert (floor.edges[edge.id].speed, floor.edges[edge.id].cost) == (0.7, 2.0)
        assert floor.to_site == (1.0, 2.0, 0.0)
        assert len(floor.vertices) == 3


async def test_a_name_that_no_file_can_have_is_said() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.typed(f"write /tmp/{'x' * 300}.yaml")
        said_yes(it)
        assert "not written" in it.desk.notices.text or "cannot be written" in it.desk.notices.text
