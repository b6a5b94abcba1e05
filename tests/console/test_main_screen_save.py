"""`:save` keeps the configuration that a console runs on: asked before anything is lost, for its owner
alone, and the same when it is read again."""

import os
import stat
from pathlib import Path

import pytest

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.load import from_text, load
from fleet_tui.config.saving import Saving
from fleet_tui.config.schema import Config, Link
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console
from tests.support.discovering import discovered
from tests.support.planted_console import SITE, planted
from tests.support.watched_store import config_of


async def typed(it: Console, line: str) -> None:
    await it.press(":")
    await it.type(line)
    await it.press("enter")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


async def test_what_was_found_is_kept_as_it_runs(server: RosbridgeServer, folder: Path) -> None:
    site = await discovered(server.url)
    async with planted(config=site.config) as it:
        it.app.main.files.saving = Saving(site.config, site)
        await typed(it, "save")
        await it.shows("config.toml: fleet-tui opens it here")
        await typed(it, "save")
        await it.shows("already saved in")
    kept = folder / "config.toml"
    assert kept.read_text() == site.text
    assert stat.S_IMODE(kept.stat().st_mode) == 0o600
    assert os.listdir(folder) == ["config.toml"]  # noqa: PTH208  # short, and blocks no loop that matters
    assert load(kept).robots == site.config.robots == from_text(kept.read_text()).robots


async def test_it_asks_before_it_writes_over_a_file(server: RosbridgeServer, folder: Path) -> None:
    site = await discovered(server.url)
    mine = folder / "my fleet.toml"
    mine.write_text("mine")
    mine.chmod(0o644)
    async with planted(config=site.config) as it:
        it.app.main.files.saving = Saving(site.config, site)
        await typed(it, "save my fleet.toml")
        await it.shows("my fleet.toml exists. Overwrite?")
        await it.press("enter")
        await it.hides("Overwrite?")
        assert mine.read_text() == "mine"
        await typed(it, "save my fleet.toml")
        await it.press("y")
        await it.shows("saved to ")
    assert mine.read_text() == site.text and stat.S_IMODE(mine.stat().st_mode) == 0o600


async def test_where_it_can_not_be_written(server: RosbridgeServer, folder: Path) -> None:
    config = config_of(server.url, 1)
    async with planted(config=config) as it:
        it.app.main.files.saving = Saving(config, await discovered(server.url))
        await typed(it, "save no/such/place.toml")
        await it.shows("not saved: no/such/place.toml: No such file or directory")
        (folder / "here").mkdir()
        await typed(it, "save here")
        await it.press("y")
        await it.shows("not saved: here: is a folder")


async def test_a_console_with_a_file_says_so_and_writes_copies(folder: Path) -> None:
    config = config_of(SITE, 1)
    path = folder / "mine.toml"
    async with planted(config=config) as it:
        it.app.main.files.saving = Saving(config_at(config, path))
        for line in ("save", "save mine.toml"):
            await typed(it, line)
            await it.shows("already saved in")
        await typed(it, "save copy.toml")
        await it.shows("copy.toml")
    assert load(folder / "copy.toml").robots == config.robots and not path.exists()


def config_at(config: Config, path: Path) -> Config:
    return Config(config.rosbridge, floors=config.floors, robots=config.robots, path=path)


def test_files_of_a_copy_are_found_from_where_it_is(tmp_path: Path) -> None:
    config = Config(
        rosbridge=Link("wss://site", ca_file="ca.pem"),
        floors=[FloorEntry("hall", map="maps/hall.yaml", graph="hall.geojson")],
        robots=[RobotEntry("r")],
        path=tmp_path / "site" / "config.toml",
    )
    (tmp_path / "else").mkdir()
    copy = load(Saving(config).write(str(tmp_path / "else" / "copy.toml")))
    for name, key in (("maps/hall.yaml", "map"), ("hall.geojson", "graph")):
        assert copy.beside(getattr(copy.floors[0], key)) == tmp_path / "site" / name
    assert copy.bridge("rosbridge").ca_file == str(tmp_path / "site" / "ca.pem")


async def test_a_demo_has_nothing_to_save(folder: Path) -> None:
    async with planted() as it:
        await typed(it, "save x.toml")
        await it.shows("nothing to save")
    assert not os.listdir(folder)  # noqa: PTH208  # short, and blocks no loop that matters
