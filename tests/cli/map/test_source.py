"""Maps of files and of bridges."""

from pathlib import Path

import pytest

from fleet_tui.cli.map.source import map_from
from fleet_tui.text.errors import FleetError, MapError
from tests.support.nav2_site import nav2_site


def test_a_file_that_is_none_is_named(tmp_path: Path) -> None:
    with pytest.raises(MapError, match=r"map no\.yaml: no such file"):
        map_from(str(tmp_path / "no.yaml"), "", 1.0)
    with pytest.raises(MapError, match="--floor is for the address"):
        map_from(str(tmp_path / "no.yaml"), "floor_0", 1.0)


def test_a_bridge_that_is_none_is_named() -> None:
    with pytest.raises(FleetError, match="connection refused"):
        map_from("ws://127.0.0.1:1", "", 1.0)


async def test_a_bridge_without_the_floor_names_its_own(tmp_path: Path) -> None:
    import asyncio

    async with nav2_site(tmp_path) as site:
        with pytest.raises(MapError, match="unknown floor atic"):
            await asyncio.to_thread(map_from, site.server.url, "atic", 5.0)
        grid, name = await asyncio.to_thread(map_from, site.server.url, "", 10.0)
        assert name == "floor_0" and (grid.frame.width, grid.frame.height) == (800, 520)
