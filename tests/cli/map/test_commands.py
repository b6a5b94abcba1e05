"""`fleet-tui map info|show|save|place`."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from fleet_tui.maps.saving import save_map
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import build_grid
from tests.support.cli import run
from tests.support.nav2_site import nav2_site


@pytest.fixture
def hall(tmp_path: Path) -> Path:
    cells = np.ones((40, 80), np.uint8)
    cells[:, 0] = 2
    return save_map(build_grid(MapFrame(0.05, 80, 40, Pose(1.0, 2.0)), cells), tmp_path / "hall")


async def test_info_names_size_and_known_area(hall: Path, tmp_path: Path) -> None:
    done = await run(tmp_path, "map", "info", str(hall))
    assert done.code == 0
    assert done.out.startswith(
        "hall.yaml: 4.0 x 2.0 m, 80 x 40 cells of 0.05 m, 8 m2 known\norigin 1.000, 2.000"
    )
    found = json.loads((await run(tmp_path, "map", "info", str(hall), "--json")).out)
    assert (found["columns"], found["origin"], round(found["known_m2"], 6)) == (80, [1.0, 2.0, 0.0], 8.0)


async def test_show_prints_it_in_80_columns(hall: Path, tmp_path: Path) -> None:
    done = await run(tmp_path, "map", "show", str(hall))
    lines = done.out.rstrip("\n").split("\n")
    assert done.code == 0 and len(lines) <= 24 and max(map(len, lines)) <= 80


async def test_a_live_map_is_saved_and_an_existing_one_asks(tmp_path: Path) -> None:
    async with nav2_site(tmp_path) as site:
        saved = await run(tmp_path, "map", "save", site.server.url, str(tmp_path / "live"))
        assert saved.code == 0 and "800 x 520 cells" in saved.out and "comparing live.yaml" in saved.err
    again = await run(tmp_path, "map", "save", str(tmp_path / "live.yaml"), str(tmp_path / "live"))
    assert again.code == 2 and "exists: use --yes" in again.err
    forced = await run(tmp_path, "map", "save", str(tmp_path / "live.yaml"), str(tmp_path / "live"), "--yes")
    assert forced.code == 0
    assert (tmp_path / "live.pgm").read_bytes() == (tmp_path / "live.pgm.bak").read_bytes()


async def test_what_is_missing_is_named(tmp_path: Path) -> None:
    done = await run(tmp_path, "map", "info", "no.yaml")
    assert (done.code, done.err) == (2, "fleet-tui: map no.yaml: no such file\n")
    assert (await run(tmp_path, "map", "save", "a.yaml")).code == 2


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """A picture of 80 x 40 pixels, black in its left column alone."""
    picture = Image.new("L", (80, 40), 255)
    picture.paste(0, (0, 0, 1, 40))
    picture.save(tmp_path / "plan.png")
    return tmp_path / "plan.png"


async def test_a_picture_becomes_a_map_by_two_points(plan: Path, tmp_path: Path) -> None:
    out, points = str(tmp_path / "floor"), ("--points", "0", "40", "80", "40")
    done = await run(tmp_path, "map", "place", str(plan), out, *points, "--distance", "4", "--at", "1", "2")
    assert done.code == 0 and "floor.yaml: 4.0 x 2.0 m, 80 x 40 cells of 0.05 m" in done.out
    again = await run(tmp_path, "map", "place", str(plan), out, *points, "--distance", "4")
    assert again.code == 2 and "exists: use --yes" in again.err
    found = json.loads((await run(tmp_path, "map", "info", f"{out}.yaml", "--json")).out)
    assert (found["origin"], round(found["occupied_m2"], 3)) == ([1.0, 2.0, 0.0], 0.1)


async def test_a_picture_has_no_metres_until_it_is_placed(plan: Path, tmp_path: Path) -> None:
    shown = await run(tmp_path, "map", "show", str(plan))
    assert shown.code == 0 and shown.out.startswith("plan.png: 80 x 40 px, without a scale\n")
    for command in ("info", "save"):
        refused = await run(tmp_path, "map", command, str(plan), *["out"][: command == "save"])
        assert (refused.code, "`fleet-tui map place` gives it one" in refused.err) == (2, True)


async def test_a_part_is_shown_with_its_pixels(plan: Path, tmp_path: Path) -> None:
    shown = await run(tmp_path, "map", "show", str(plan), "--part", "0", "0", "20", "10")
    heads, first = shown.out.split("\n")[1:3]
    numbers = [int(one) for one in heads.split()]
    assert numbers == sorted(numbers) and numbers[0] <= 0 < 20 <= numbers[-1] + 5
    assert first.split()[0].lstrip("-").isdigit() and all(len(line) <= 80 for line in shown.out.split("\n"))


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (["--distance", "1e300"], "must be from 0.004 to 4000 m, not 1e+300"),
        (["--distance", "1e-300"], "must be from 0.004 to 4000 m, not 1e-300"),
        (["--distance", "nan"], "not nan"),
        (["--distance", "4", "--at", "nan", "0"], "must be within 1,000,000 m"),
        (["--distance", "4", "--heading", "1e300"], "must be from -360 to 360 degrees"),
    ],
)
async def test_numbers_that_give_no_map_are_refused_before_anything_is_written(
    hall: Path, tmp_path: Path, more: list[str], words: str
) -> None:
    points, picture = ["--points", "0", "0", "40", "0"], str(hall.with_suffix(".pgm"))
    done = await run(tmp_path, "map", "place", picture, str(tmp_path / "p"), *points, *more)
    assert done.code == 2 and words in done.err and not (tmp_path / "p.pgm").exists()


@pytest.mark.parametrize("part", ["0 0 0 0", "0 0 5 0", "100000 0 10 10", "0 40 1 1", "nan 0 5 5"])
async def test_a_part_without_pixels_is_refused(hall: Path, tmp_path: Path, part: str) -> None:
    done = await run(tmp_path, "map", "show", str(hall), "--part", *part.split())
    assert (done.code, done.out.count("\n")) == (2, 0)
    assert "has no pixels of the map of 80 x 40 px" in done.err or "nan is not a number" in done.err


async def test_bad_files_are_named_in_plain_words(tmp_path: Path) -> None:
    (tmp_path / "dir.yaml").mkdir()
    (tmp_path / "empty.yaml").touch()
    (tmp_path / "bin.yaml").write_bytes(b"a: \x00\xff")
    (tmp_path / "broken.yaml").write_text("image: [")
    said = {
        "dir": "unreadable: a folder: name a file",
        "empty": "not a map_server file: no image",
        "bin": "unreadable: not text in UTF-8",
        "broken": "unreadable: not YAML: expected the node content, but found '<stream end>' in line 1",
        "missing": "no such file",
    }
    for name, words in said.items():
        done = await run(tmp_path, "map", "info", str(tmp_path / f"{name}.yaml"))
        assert (done.code, done.err) == (2, f"fleet-tui: map {name}.yaml: {words}\n")


async def test_a_map_in_a_missing_folder_names_the_folder(hall: Path, tmp_path: Path) -> None:
    done = await run(tmp_path, "map", "save", str(hall), str(tmp_path / "none" / "m"))
    target = tmp_path / "none" / "m.pgm"
    assert done.code == 2 and f"{target} cannot be written: no folder {target.parent}" in done.err
