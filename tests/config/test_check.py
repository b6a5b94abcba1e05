"""Checks of the whole configuration: names without a match, topics that cannot be distinguished."""

from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.check import checked, missing_files
from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Alarms, Config, Link, Notify
from fleet_tui.text.errors import did_you_mean

GOOD = Config(
    floors=[FloorEntry("floor_0"), FloorEntry("floor_1")],
    robots=[RobotEntry("robot_0"), RobotEntry("robot_1", floors=["floor_1"])],
)


def only(config: Config) -> str:
    (line,) = checked(config)
    return line


def test_a_good_one_has_nothing_to_say() -> None:
    assert checked(GOOD) == []


@pytest.mark.parametrize(
    "url", ["", "127.0.0.1:9090", "http://a", "ws://", "ws://:9090", "ws://[::1", "ws://a:70000", "ws://a:0"]
)
def test_an_address_that_is_none(url: str) -> None:
    assert only(replace(GOOD, rosbridge=Link(url))).startswith(f"rosbridge.url: {url!r} is not an address")
    assert only(replace(GOOD, links={"b": Link(url)})).startswith("links.b.url: ")


@pytest.mark.parametrize("url", ["ws://a", "wss://a.b.c:1/x?y", "ws://[::1]:9090", "ws://10.0.0.1:9090"])
def test_an_address(url: str) -> None:
    assert checked(replace(GOOD, rosbridge=Link(url))) == []


def test_the_default_links_name_is_taken() -> None:
    assert only(replace(GOOD, links={"rosbridge": Link()})).startswith("links.rosbridge: ")


@pytest.mark.parametrize("name", ["", "a b", "{robot}", "/a", "rob\x1bot", "ñu", "a\n"])
def test_names_that_ros_would_not_take(name: str) -> None:
    assert f"robots[0].name: {name!r} is not a ROS name" in only(replace(GOOD, robots=[RobotEntry(name)]))
    assert any(
        "floors[0].name" in line for line in checked(replace(GOOD, floors=[FloorEntry(name)], robots=[]))
    )


def test_none_and_twice() -> None:
    assert only(replace(GOOD, robots=[])) == "robots: empty: add [[robots]] with a name"
    assert "floors: empty: add [[floors]] with a name" in checked(Config(robots=GOOD.robots[:1]))
    twice = replace(GOOD, robots=[RobotEntry("r"), RobotEntry("r")])
    assert only(twice) == "robots: name r used 2 times"
    floors = replace(GOOD, floors=[FloorEntry("floor_1"), FloorEntry("floor_1")])
    assert only(floors) == "floors: name floor_1 used 2 times"


def test_two_floors_in_one_frame() -> None:
    config = replace(GOOD, floors=[FloorEntry("floor_0", frame_id="/floor_1"), FloorEntry("floor_1")])
    assert "frame_id floor_1 used by floor_0 and floor_1" in only(config)


def test_references_that_lead_nowhere_name_the_nearest() -> None:
    config = replace(
        GOOD, robots=[RobotEntry("r", floors=["flor_1"], link="sit_b")], links={"site_b": Link()}
    )
    assert checked(config) == [
        "robots[0].floors: unknown floor 'flor_1', did you mean floor_1?",
        "robots[0].link: unknown link 'sit_b', did you mean site_b?",
    ]


def test_keys_and_limits_are_checked_too() -> None:
    assert only(replace(GOOD, keys={"ordr": "o"})) == "keys.ordr: unknown key id, did you mean order?"
    assert "battery_critical" in only(replace(GOOD, alarms=Alarms(battery_low=5.0)))


@pytest.mark.parametrize(
    ("alarms", "says"),
    [
        (Alarms(battery_low=99.0), "alarms.battery_band: battery_low and battery_band together must not be"),
        (Alarms(bell=["hihg"]), "alarms.bell: unknown priority 'hihg', did you mean high?"),
        (Alarms(notify=["all"]), "alarms.notify: unknown priority 'all', use high, medium, low"),
    ],
)
def test_alarms_that_cannot_work(alarms: Alarms, says: str) -> None:
    assert only(replace(GOOD, alarms=alarms)).startswith(says)


def test_every_priority_can_ring() -> None:
    assert checked(replace(GOOD, alarms=Alarms(bell=["high", "medium", "low"], notify=["high"]))) == []


def test_a_file_of_a_floor_that_is_not_there_is_named(tmp_path: Path) -> None:
    (tmp_path / "there.yaml").touch()
    floors = [
        FloorEntry("a", "there.yaml"),
        FloorEntry("b", "gone.yaml", "gone.json"),
        FloorEntry("c", "~no-such-user-x/y"),
    ]
    config = replace(GOOD, floors=floors, path=tmp_path / "config.toml")
    assert missing_files(config) == [
        "floors[1].map: file not found: gone.yaml",
        "floors[1].graph: file not found: gone.json",
        "floors[2].map: file not found: ~no-such-user-x/y",
    ]
    assert config.beside("there.yaml") == tmp_path / "there.yaml"
    assert config.beside(str(tmp_path / "abs.png")) == tmp_path / "abs.png"


def test_only_a_near_name_is_suggested() -> None:
    assert did_you_mean("robot_O", ["robot_0", "base"]) == ", did you mean robot_0?"
    assert did_you_mean("xyz", ["robot_0", "base"]) == ""


def test_a_notification_of_an_unknown_class_or_without_a_program_is_named() -> None:
    wrong = replace(GOOD, notify=Notify([""], ["high", "batery"]))
    assert checked(wrong) == [
        "notify.classes: no priority or class 'batery', did you mean battery?",
        "notify.command: begins with the name of a program",
    ]
