"""From a file to a player: the fleet of the recording, the keys of who watches it."""

from pathlib import Path

import pytest

from fleet_tui.config.schema import Config
from fleet_tui.model.events import TimePassed
from fleet_tui.records.recording.play.start import playing
from fleet_tui.text.errors import ConfigError
from tests.support.fleets import T0, WALL
from tests.support.tapes import MadeUp
from tests.support.watched_store import config_of


@pytest.fixture
def night(tmp_path: Path) -> Path:
    made = MadeUp(config_of("ws://site:9090", robots=3))
    for second in range(10):
        made.tell(second, TimePassed(T0 + second, WALL + second))
    return made.written(tmp_path / "night.jsonl.gz").path


def test_the_fleet_is_the_recordings_and_the_keys_are_ours(night: Path, tmp_path: Path) -> None:
    found = Config(keys={"order": "O"}, path=tmp_path / "config.toml")
    player, config = playing(night, found, 2.0, "+5s", lambda _share: None, ["made of a bag"])
    assert [robot.name for robot in config.robots] == ["robot_0", "robot_1", "robot_2"]
    assert (config.keys, config.path, config.operator.read_only) == (found.keys, found.path, True)
    assert player.state.now == T0 + 5
    assert (player.moment.speed, player.moment.note) == (2.0, "made of a bag")


@pytest.mark.parametrize(("name", "start", "says"), [("gone", "", "no such file"), ("", "noon", "noon")])
def test_a_file_or_a_time_that_cannot_be_is_a_problem_of_the_configuration(
    night: Path, name: str, start: str, says: str
) -> None:
    with pytest.raises(ConfigError, match=says):
        playing(night.with_name(name) if name else night, Config(), 1.0, start, lambda _share: None)
