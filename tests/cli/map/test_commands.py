"""`fleet-tui map info|show|save`."""

import json
from pathlib import Path

import numpy as np
import pytest

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
    assert (done.code, done.err) == (1, "fleet-tui: map no.yaml: no such file\n")
    assert (await run(tmp_path, "map", "save", "a.yaml")).code == 2
