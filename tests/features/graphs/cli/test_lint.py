"""`graph lint`: findings, counts, exit codes."""

from pathlib import Path

import pytest

from fleet_tui.model.graphs.document import GraphFormat
from tests.support.cli import run
from tests.support.graph_files import line_graph, sample, write_text

GOOD = """
levels:
  L1:
    vertices: [[0, 0, {name: Base, is_charger: true}], [2, 0, {name: Store}]]
    lanes: [[0, 1, {}], [1, 0, {}]]
"""


async def test_nothing_to_say_but_the_counts(tmp_path: Path) -> None:
    (tmp_path / "g.yaml").write_text(GOOD)
    done = await run(tmp_path, "graph", "lint", "g.yaml")
    assert (done.code, done.err) == (0, "")
    assert done.out == "g.yaml: rmf, 1 floor, 2 vertices, 1 edge, 2 labels: 0 errors, 0 warnings\n"


async def test_findings_then_the_counts(tmp_path: Path) -> None:
    (tmp_path / "g.yaml").write_text(write_text(sample(), GraphFormat.NATIVE))
    done = await run(tmp_path, "graph", "lint", "g.yaml", "--from", "native")
    assert done.code == 1
    assert done.out.splitlines() == [
        "warning: vertex 0 (Base): robots read a missing id as 0, that is as this vertex",
        "warning: vertex 2 (yes): a dead end, no way back to the others",
        "g.yaml: native, 1 floor, 4 vertices, 4 edges, 3 labels: 0 errors, 2 warnings",
    ]


async def test_control_characters_are_shown_as_text(tmp_path: Path) -> None:
    vertex = '{id: "\\e", x: 0, y: .nan, label: "\\e]0;x"}'
    text = f'fleet_tui_graph: 1\nfloors: {{"a\\e[2J": {{vertices: [{vertex}]}}, b: {{}}}}'
    (tmp_path / "g.yaml").write_text(text)
    done = await run(tmp_path, "graph", "lint", "g.yaml")
    assert done.code == 1 and "\x1b" not in done.out + done.err
    assert "error: a␛[2J: vertex ␛ (␛]0;x): (0, nan) m is not a place on a floor" in done.out


async def test_a_width_that_is_no_number_is_refused(tmp_path: Path) -> None:
    (tmp_path / "g.yaml").write_text(GOOD)
    done = await run(tmp_path, "graph", "lint", "g.yaml", "--width", "nan")
    assert done.code == 2 and "nan is not a number" in done.err


async def test_against_a_map(tmp_path: Path) -> None:
    (tmp_path / "g.yaml").write_text(write_text(line_graph((1.0, 1.0), (50.0, 1.0)), GraphFormat.OH))
    (tmp_path / "m.pgm").write_bytes(b"P5\n40 40\n255\n" + bytes([254]) * 1600)
    (tmp_path / "m.yaml").write_text("image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n")
    done = await run(tmp_path, "graph", "lint", "g.yaml", "--map", "m.yaml")
    assert "error: vertex 2: (50.00, 1.00) m is off the map" in done.out
    assert (await run(tmp_path, "graph", "lint", "g.yaml", "--map", "no.yaml")).code == 2


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "fleet-tui: g: empty; known formats: native"),
        (b"\xff\xfe", "fleet-tui: g: not UTF-8 at byte 0: save it as UTF-8"),
        (b"hello", "fleet-tui: g: no known format"),
        (
            b'{"type": "FeatureCollection", "features": [{"id": NaN}]}',
            "not JSON: invalid character in line 1",
        ),
        (b"a: !!python/name:os.system x", "tag"),
        (b"<!DOCTYPE a []><model/>", "a DTD or entities"),
        (b"[" * 100_000, "nested too deep"),
    ],
)
async def test_unreadable_files(tmp_path: Path, content: bytes, said: str) -> None:
    (tmp_path / "g").write_bytes(content)
    done = await run(tmp_path, "graph", "lint", "g")
    assert (done.code, done.out) == (2, "") and said in done.err and "Traceback" not in done.err


async def test_what_is_no_file(tmp_path: Path) -> None:
    for name in ("gone", ".", "/dev/stdin", "/dev/zero", "-"):
        done = await run(tmp_path, "graph", "lint", name)
        assert (done.code, done.out) == (2, "") and name in done.err, name
