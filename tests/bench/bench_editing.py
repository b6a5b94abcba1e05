"""P16: a step of the graph editor until its picture is made. Run: python -m tests.bench.bench_editing"""

import random
import statistics
import time
from dataclasses import replace

from fleet_tui.features.graphs.edit_mode import EditMode, cell_metres
from fleet_tui.features.graphs.rules import edits
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.draft import GraphDraft
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.scene import Scene
from tests.bench.bench_map import SIDE, warehouse
from tests.bench.rows import Row, p95, row

VERTICES, EDGES = 2000, 5000
WIDTH, HEIGHT = 120, 40
METRES = SIDE * 0.05


def large_floor() -> DocumentFloor:
    """Vertices in rows, each with edges to some of its neighbours."""
    rng = random.Random(3)
    columns = 50
    pitch = METRES / columns
    vertices = {
        str(n): DocumentVertex(
            str(n), (n % columns + 0.5) * pitch, (n // columns + 0.5) * pitch, f"V {n}" if n % 5 == 0 else ""
        )
        for n in range(1, VERTICES + 1)
    }
    ends = set[tuple[str, str]]()
    while len(ends) < EDGES:
        start = rng.randrange(1, VERTICES + 1)
        end = start + rng.choice((1, columns, columns + 1, columns - 1))
        if end <= VERTICES:
            ends.add((str(start), str(end)))
    edges = {str(n): DocumentEdge(str(n), *pair) for n, pair in enumerate(sorted(ends), 1)}
    return DocumentFloor("floor_0", vertices, edges)


def times_of(floor: DocumentFloor, scene: Scene, steps: int) -> tuple[list[float], list[float]]:
    """Milliseconds of each cursor step, and of each vertex with an edge, to the finished picture."""
    rng = random.Random(5)
    picture, draft = MapPicture(), GraphDraft(floor)
    picture.show(scene)
    picture.cells(WIDTH, HEIGHT, True)
    mode = picture.mode = EditMode(floor, (METRES / 2, METRES / 2))
    picture.options = replace(picture.options, edges=True)
    moves, drawn = list[float](), list[float]()
    for _ in range(steps):
        start = time.perf_counter()
        mode.move(picture.viewport, scene, rng.choice((-1, 1)), rng.choice((-1, 1)))
        picture.point()
        picture.cells(WIDTH, HEIGHT, True)
        moves.append((time.perf_counter() - start) * 1000)
        start = time.perf_counter()
        at = edits.snapped(draft.floor, *mode.cursor, cell_metres(picture.viewport, scene) / 2)
        ids = draft.free_ids()
        vertex = DocumentVertex(next(ids), *at)
        edge = edits.connected(next(ids), next(ids), "1", vertex.id)
        change = edits.joined(edits.added(vertex), edge)
        draft.do(change)
        mode.show(draft.floor, change)
        picture.cells(WIDTH, HEIGHT, True)
        drawn.append((time.perf_counter() - start) * 1000)
    return moves, drawn


def main() -> list[Row]:
    grid = warehouse()
    scene = Scene("floor_0", grid.frame, grid)
    _, small = times_of(DocumentFloor("floor_0", {"1": DocumentVertex("1", 1.0, 1.0)}), scene, 100)
    moves, drawn = times_of(large_floor(), scene, 100)
    what = f"editing {VERTICES} vertices, {EDGES} edges"
    return [
        row("P16", f"{what}: cursor -> picture, p95", p95(moves), "ms", 20.0),
        row("P16", f"{what}: new edge -> picture, median", statistics.median(drawn), "ms"),
        row("P16", f"{what}: new edge -> picture, p95", p95(drawn), "ms", 20.0, p95(small), "an empty graph"),
    ]


if __name__ == "__main__":
    main()
