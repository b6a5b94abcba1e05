"""`graph show`: 80x24 without a terminal."""

from pathlib import Path

import numpy as np

from fleet_tui.features.graphs.cli.show import floor_picture
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphFormat
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.cli import run
from tests.support.graph_files import line_graph, sample, write_text


async def test_a_picture_of_80x24(tmp_path: Path) -> None:
    (tmp_path / "s.yaml").write_text(write_text(sample(), GraphFormat.NATIVE))
    done = await run(tmp_path, "graph", "show", "s.yaml")
    lines = done.out.splitlines()
    assert (done.code, done.err, len(lines)) == (0, "", 24)
    assert lines[0] == "ground: 4 vertices, 4 edges, 3 labels"
    assert all(cell_width(line) <= 80 for line in lines)
    assert "Base" in done.out and any("\u2800" < letter <= "\u28ff" for letter in done.out)


def test_edges_lie_between_their_vertices() -> None:
    text = floor_picture(line_graph((0.0, 0.0), (10.0, 0.0)).floors["f"], None, 40, 9, Drawing.BRAILLE)
    (row,) = [line for line in text.splitlines() if line.strip()]
    assert row.strip()[0] == row.strip()[-1] == "•" and " " not in row.strip()


def test_over_a_map() -> None:
    cells = np.full((100, 200), FREE, np.uint8)
    cells[:2], cells[-2:] = OCCUPIED, OCCUPIED
    grid = build_grid(MapFrame(0.05, 200, 100), cells)
    text = floor_picture(line_graph((1.0, 1.0), (9.0, 4.0)).floors["f"], grid, 60, 20, Drawing.ASCII)
    assert "#" in text and "+" in text and text.isascii()


def test_places_and_labels_of_any_sort() -> None:
    vertices = {
        str(n): DocumentVertex(str(n), x, x, label)
        for n, (x, label) in enumerate(
            [(0.0, "名" * 300), (float("nan"), "a"), (1e300, "b"), (1.0, "\x1b[2J"), (1e5, "é")]
        )
    }
    for drawing in Drawing:
        text = floor_picture(DocumentFloor("f", vertices), None, 20, 8, drawing)
        assert "\x1b" not in text and all(cell_width(line) <= 20 for line in text.splitlines())
    assert floor_picture(DocumentFloor("f"), None, 20, 8, Drawing.BRAILLE).strip() == ""


async def test_unreadable(tmp_path: Path) -> None:
    assert (await run(tmp_path, "graph", "show", "gone")).code == 2
