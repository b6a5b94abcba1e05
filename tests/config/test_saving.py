"""A configuration is written whole or not at all, for its owner alone."""

import stat
from pathlib import Path

import pytest

from fleet_tui.config.fleet import watching
from fleet_tui.config.load import load
from fleet_tui.config.saving import Saving, write_config
from fleet_tui.text.errors import FleetError
from tests.support.watched_store import config_of


def test_what_was_written_reads_as_the_same(tmp_path: Path) -> None:
    config = config_of("ws://a:9090", 2)
    path = Saving(config).write(str(tmp_path / "copy.toml"))
    assert load(path).robots == config.robots
    assert stat.S_IMODE(path.stat().st_mode) == 0o600


def test_where_it_can_not_be_written_nothing_is_left(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    for name, words in (("folder", "is a folder: name a file"), ("gone/x.toml", "No such file")):
        with pytest.raises(FleetError, match=words):
            write_config("x = 1", str(tmp_path / name))
    assert [path.name for path in tmp_path.iterdir()] == ["folder"]


def test_robots_that_came_later_are_written_and_a_console_that_only_watches_is_no_setting(
    tmp_path: Path,
) -> None:
    saving = Saving(config_of("ws://site:9090", 1))
    saving.extend(watching(config_of("ws://site:9090", 2, 2)))
    read = load(saving.write(str(tmp_path / "config.toml")))
    assert (len(read.robots), len(read.floors), read.operator.read_only) == (2, 2, False)
