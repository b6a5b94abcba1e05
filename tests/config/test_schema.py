"""The shape of a configuration: bridges that are used, files beside it, addresses without secrets."""

from pathlib import Path

import pytest

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link, expanded, link_key


@pytest.mark.parametrize(
    ("url", "shown"),
    [
        ("ws://robot:9090", "ws://robot:9090"),
        ("ws://ana:hush@robot", "ws://***@robot"),
        ("ws://robot/?token=hush", "ws://robot/?***"),
        ("ana:hu/sh@robot", "***@robot"),
    ],
)
def test_an_address_is_shown_without_what_may_be_secret(url: str, shown: str) -> None:
    assert Link(url).shown == shown and "hush" not in Link(url).shown


def test_only_bridges_on_which_a_robot_hangs_are_used() -> None:
    links = {"b": Link("ws://b"), "c": Link("ws://c")}
    assert list(Config(robots=[RobotEntry("r", link="b")], links=links).bridges) == ["b"]
    assert list(Config(links=links).bridges) == ["rosbridge"]
    assert (link_key("rosbridge"), link_key("b")) == ("rosbridge", "links.b")


def test_files_lie_beside_the_config_and_the_home_is_known() -> None:
    config = Config(path=Path("/etc/fleet/config.toml"))
    assert config.beside("hall.yaml") == Path("/etc/fleet/hall.yaml")
    assert config.beside("/maps/hall.yaml") == Path("/maps/hall.yaml")
    assert expanded("~/x") == Path.home() / "x"
    assert expanded("~nobody-of-that-name/x") == Path("~nobody-of-that-name/x")


def test_a_robot_without_floors_can_be_on_all() -> None:
    config = Config(floors=[FloorEntry("a", frame_id="/map"), FloorEntry("b")])
    assert config.floors_of(RobotEntry("r")) == ["a", "b"] and config.floors_of(
        RobotEntry("r", floors=["b"])
    ) == ["b"]
    assert [floor.frame for floor in config.floors] == ["map", "b"]
