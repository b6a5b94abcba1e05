"""Profiles that cannot work: names that a kind does not know, topics that can't be told apart."""

import math

import pytest
from msgspec.structs import replace

from fleet_tui.config.check import checked
from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.robots.profile import Profile
from tests.support.watched_store import config_of

GOOD = config_of("ws://a", 2, 2)


def with_profile(**changes: object) -> Config:
    return replace(GOOD, profile=Profile(**changes))  # type: ignore[arg-type]  # the cases give the types


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"name": "oh_resources"}, "profile.name: unknown kind 'oh_resources', did you mean oh_ressources?"),
        ({"topics": {"poes": "/p"}}, "profile.topics.poes: unknown key, did you mean pose?"),
        ({"types": {"grap": "a/B"}}, "profile.types.grap: unknown key, did you mean graph?"),
        ({"services": {"pauze": "/p"}}, "profile.services.pauze: unknown key, did you mean pause?"),
        ({"fields": {"vertex.ide": "i"}}, "profile.fields.vertex.ide: unknown key, did you mean vertex.id?"),
        ({"topics": {"pose": "/{robot}/{floor}/p"}}, "profile.topics.pose: {floor} is not available here"),
        ({"topics": {"map": "/{robt}/{floor}/{robot}"}}, "profile.topics.map: {robt} is not available here"),
        ({"services": {"pause": "/{}/{robot}"}}, "profile.services.pause: {} is not available here"),
        (
            {"service_types": {"resume": "nav2_msgs/srv/ManageLifecycleNodes"}},
            "profile.service_types.resume: a resume can't fill the fields of"
            " nav2_msgs/srv/ManageLifecycleNodes: name a service of std_srvs/Trigger or std_srvs/Empty",
        ),
        ({"refusals": ("ok", "(")}, "profile.refusals[1]: '(' is not a regular expression"),
        (
            {"refusals": ("a{99999999999}",)},
            "profile.refusals[0]: 'a{99999999999}' is not a regular expression",
        ),
        (
            {"topics": {"pose": "/pose"}},
            "profile.topics.pose: /pose is used by pose of robot_0 and pose of robot_1",
        ),
        ({"topics": {"graph": "/{robot}/graph"}}, "graph of robot_0 floor_0 and graph of robot_0 floor_1"),
        ({"scales": {"pose": math.nan}}, "profile.scales.pose: nan is not a factor: use a number above 0"),
        ({"scales": {"pose": 0.0}}, "profile.scales.pose: 0 is not a factor: use a number above 0"),
        ({"silence": {"pose": -5.0}}, "profile.silence.pose: -5 is not a duration: use seconds above 0"),
        (
            {"topics": {"cargo": "/{robot}/pose"}},
            "/robot_0/pose is used by pose of robot_0 and cargo of robot_0",
        ),
    ],
)
def test_a_profile_that_cannot_work(changes: dict[str, object], says: str) -> None:
    assert any(says in line for line in checked(with_profile(**changes)))


def test_one_topic_on_two_bridges_is_two_topics() -> None:
    robots = [RobotEntry("robot_0"), RobotEntry("robot_1", link="b")]
    profile = Profile(topics={"pose": "/pose"})
    assert checked(Config(floors=GOOD.floors, robots=robots, links={"b": Link()}, profile=profile)) == []


@pytest.mark.parametrize("key", ["drive", "initial_pose"])
def test_a_topic_that_moves_two_robots_is_refused(key: str) -> None:
    both = with_profile(topics={key: "/all"})
    first, second = (robot.name for robot in both.robots)
    says = f"profile.topics.{key}: /all moves both {first} and {second}: add {{robot}}"
    assert checked(both) == [says]
    apart = replace(both, robots=[both.robots[0], replace(both.robots[1], link="b")], links={"b": Link()})
    assert checked(apart) == [], "two bridges"


def test_a_topic_may_be_left_out() -> None:
    assert checked(with_profile(topics={"cargo": "", "battery": ""})) == []
