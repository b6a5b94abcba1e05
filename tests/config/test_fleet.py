"""Profiles: fields at other paths, scales, several kinds in one configuration."""

from pathlib import Path
from typing import Any

import pytest

from fleet_tui.config.fleet import adapters_of, drive_of, feeds_of
from fleet_tui.config.load import load, read
from fleet_tui.config.schema import Config
from fleet_tui.model.events import BatteryReported, Event, ObstacleReported, PausedReported, PoseReported
from fleet_tui.model.geometry import Pose
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.text.errors import WireError

SITE = '[[floors]]\nname = "hall"\n[[robots]]\nname = "r1"\n'
TURN = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
HEADER = {"frame_id": "hall", "stamp": {"secs": 3, "nsecs": 0}}


def configured(folder: Path, text: str) -> Config:
    path = folder / "config.toml"
    path.write_text(text)
    return load(path)


def problems(folder: Path, text: str) -> list[str]:
    path = folder / "config.toml"
    path.write_text(text)
    return read(path)[1]


def facts(config: Config, key: str, message: dict[str, Any], robot: str = "r1") -> list[Event]:
    adapters = adapters_of(config)
    link = next(one.link for one in config.robots if one.name == robot)
    feed = next(one for one in feeds_of(config, adapters, link) if one.key == key and robot in one.robots)
    return list(adapters[robot].read(feed, message, 9.0))


class TestPaths:
    def test_a_pose_with_covariance_of_amcl(self, tmp_path: Path) -> None:
        config = configured(
            tmp_path,
            SITE
            + '[profile.topics]\npose = "/{robot}/amcl_pose"\n'
            + '[profile.types]\npose = "geometry_msgs/PoseWithCovarianceStamped"\n'
            + '[profile.fields]\n"pose.position" = "pose.pose.position"\n'
            + '"pose.orientation" = "pose.pose.orientation"\n',
        )
        placed = {"position": {"x": 4.0, "y": 5.0, "z": 0.0}, "orientation": TURN}
        message = {"header": HEADER, "pose": {"pose": placed, "covariance": [None] * 36}}
        assert facts(config, "pose", message) == [PoseReported("r1", 9.0, Pose(4.0, 5.0), "hall", 3.0)]

    def test_a_battery_state_from_0_to_1(self, tmp_path: Path) -> None:
        config = configured(
            tmp_path,
            SITE
            + '[profile.types]\nbattery = "sensor_msgs/BatteryState"\n'
            + '[profile.fields]\n"battery.data" = "percentage"\n[profile.scales]\nbattery = 100\n',
        )
        message = {"voltage": 24.0, "percentage": 0.5}
        assert facts(config, "battery", message) == [BatteryReported("r1", 9.0, 50.0)]

    def test_numbers_and_words_that_lie_deeper(self, tmp_path: Path) -> None:
        config = configured(
            tmp_path,
            SITE
            + '[profile.topics]\npaused = "/{robot}/state"\n'
            + '[profile.fields]\n"obstacle.data" = "state.contact.s"\n"paused.data" = "state.is_paused"\n'
            + "[profile.scales]\nobstacle = 0.001\n",
        )
        assert facts(config, "obstacle", {"state": {"contact": {"s": 2500}}}) == [
            ObstacleReported("r1", 9.0, 2.5)
        ]
        assert facts(config, "paused", {"state": {"is_paused": True}}) == [PausedReported("r1", 9.0, True)]

    def test_a_frame_and_a_stamp_from_elsewhere(self, tmp_path: Path) -> None:
        config = configured(tmp_path, SITE + '[profile.fields]\n"pose.frame_id" = "floor"\n')
        message = {
            "header": HEADER,
            "floor": "attic",
            "pose": {"position": {"x": 1, "y": 2}, "orientation": TURN},
        }
        (fact,) = facts(config, "pose", message)
        assert isinstance(fact, PoseReported) and (fact.frame_id, fact.stamp) == ("attic", 3.0)

    def test_of_nav2_too(self, tmp_path: Path) -> None:
        config = configured(
            tmp_path,
            SITE + '[profile]\nkind = "nav2"\n[profile.fields]\n"battery.percentage" = "charge.share"\n'
            "[profile.scales]\nbattery = 100\nodometry = 0.001\n",
        )
        (battery,) = facts(config, "battery", {"charge": {"share": 0.25}})
        assert battery == BatteryReported("r1", 9.0, 25.0, is_raw=False)

    def test_a_path_that_leads_nowhere_is_named_with_the_remedy(self, tmp_path: Path) -> None:
        config = configured(tmp_path, SITE + '[profile.fields]\n"battery.data" = "state.level"\n')
        with pytest.raises(
            WireError, match=r"`level` - at `\$\.state\.level`: correct the fields of its profile"
        ):
            facts(config, "battery", {"state": {}})

    @pytest.mark.parametrize(
        ("line", "said"),
        [
            (
                '[profile.fields]\n"pose.positon" = "x"',
                "profile.fields.pose.positon: unknown key, did you mean",
            ),
            ("[profile.scales]\nbatery = 1", "profile.scales.batery: unknown key, did you mean battery"),
            ("[profile.scales]\ncargo = 1", "profile.scales.cargo: unknown key"),
            ('[profile.scales]\nbattery = "auto"', "profile.scales.battery: expected a number, got text"),
            ("[profile.silence]\nbatery = 1", "profile.silence.batery: unknown key, did you mean battery"),
        ],
    )
    def test_keys_that_do_not_exist_are_named(self, tmp_path: Path, line: str, said: str) -> None:
        (problem,) = problems(tmp_path, SITE + line + "\n")
        assert problem.startswith(said)


MIXED = """
[rosbridge]
url = "ws://a:9090"
[links.hall_b]
url = "ws://b:9090"
profile = "turtles"
[[floors]]
name = "hall"
[[robots]]
name = "r1"
[[robots]]
name = "t1"
link = "hall_b"
[[robots]]
name = "n1"
profile = "nav2"
[profile]
name = "oh_ressources"
[profiles.turtles]
kind = "nav2"
[profiles.turtles.topics]
odometry = "/{robot}/wheels"
[profiles.turtles.nav2]
pause = ""
"""


class TestSeveralKinds:
    def test_each_robot_has_its_own(self, tmp_path: Path) -> None:
        config = configured(tmp_path, MIXED)
        adapters = adapters_of(config)
        assert {name: it.kind.name for name, it in adapters.items()} == {
            "r1": "oh_ressources",
            "t1": "nav2",
            "n1": "nav2",
        }
        assert adapters["t1"].names.table == "profiles.turtles"
        assert adapters["t1"].names.topic("odometry", "t1") == "/t1/wheels"
        assert adapters["n1"].names.topic("odometry", "n1") == "/n1/odom"
        assert not adapters["t1"].kind.can("pause") and adapters["n1"].kind.can("pause")

    def test_fields_and_scales_are_those_of_its_own_profile(self, tmp_path: Path) -> None:
        text = MIXED + '[profiles.turtles.fields]\n"battery.percentage" = "level"\n'
        config = configured(tmp_path, text)
        assert facts(config, "battery", {"level": 0.5}, "t1") == [
            BatteryReported("t1", 9.0, 0.5, is_raw=True)
        ]
        with pytest.raises(WireError, match="level"):
            facts(config, "battery", {"percentage": 0.5}, "t1")

    @pytest.mark.parametrize(
        ("old", "new", "said"),
        [
            (
                'profile = "turtles"',
                'profile = "turtle"',
                "links.hall_b.profile: unknown kind or profile 'turtle', did you mean turtles",
            ),
            (
                'profile = "nav2"',
                'profile = "nav3"',
                "robots[2].profile: unknown kind or profile 'nav3', did you mean nav2",
            ),
            ('kind = "nav2"', 'kind = "nav"', "profiles.turtles.kind: unknown kind 'nav', did you mean nav2"),
            (
                'name = "oh_ressources"',
                'name = "oh_resources"',
                "profile.name: unknown kind 'oh_resources', did you mean oh_ressources",
            ),
            (
                "odometry =",
                "odometri =",
                "profiles.turtles.topics.odometri: unknown key, did you mean odometry",
            ),
            ('pause = ""', 'pause = "hould"', "profiles.turtles.nav2: "),
            ('pause = ""', 'pauze = ""', "profiles.turtles.nav2.pauze: unknown key, did you mean pause"),
            (
                "[profiles.turtles.nav2]",
                "[profiles.turtles.oh_ressources]",
                "profiles.turtles.oh_ressources: not a table of kind nav2",
            ),
            (
                '"/{robot}/wheels"',
                '"/{floor}/wheels"',
                "profiles.turtles.topics.odometry: {floor} is not available here",
            ),
            (
                'kind = "nav2"',
                'kind = "nav2"\nname = "oh_ressources"',
                "profiles.turtles.name: 'oh_ressources' and kind 'nav2' are the same setting",
            ),
        ],
    )
    def test_what_is_wrong_is_named(self, tmp_path: Path, old: str, new: str, said: str) -> None:
        found = problems(tmp_path, MIXED.replace(old, new, 1))
        assert found and found[0].startswith(said), found


CARTS = """
[drive]
max_linear = 0.5
robot_timeout = 0.5
[profiles.cart]
kind = "nav2"
[profiles.cart.drive]
max_linear = 0.2
[[robots]]
name = "r2"
profile = "cart"
"""


class TestDrive:
    def test_a_profile_has_its_own_limits_and_no_timeout_of_others(self, tmp_path: Path) -> None:
        config = configured(tmp_path, SITE + CARTS)
        first, cart = (drive_of(config, robot) for robot in config.robots)
        assert first == DriveConfig(max_linear=0.5, robot_timeout=0.5)
        assert cart == DriveConfig(max_linear=0.2), "what is not known of it is asked"

    @pytest.mark.parametrize(
        ("line", "said"),
        [
            ("max_linear = -0.2", "profiles.cart.drive.max_linear: expected a number > 0.0"),
            ("max_liner = 0.2", "profiles.cart.drive.max_liner: unknown key, did you mean max_linear?"),
        ],
    )
    def test_its_mistakes_are_named(self, tmp_path: Path, line: str, said: str) -> None:
        assert problems(tmp_path, SITE + CARTS.replace("max_linear = 0.2", line)) == [said]
