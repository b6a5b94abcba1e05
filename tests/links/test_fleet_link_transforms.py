"""Robots whose place only transforms tell, over a real loopback bridge."""

import math

import msgspec

from fleet_tui.config.schema import Config
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Robot
from fleet_tui.simulator.kinds import play
from tests.support.links import finished, linked
from tests.support.nav2_site import Site, nav2_ready, reached

R0, R1 = "robot_0", "robot_1"


def with_topics(config: Config, **topics: str) -> Config:
    profile = config.profile
    return msgspec.structs.replace(
        config, profile=msgspec.structs.replace(profile, topics={**profile.topics, **topics})
    )


def asked_for(site: Site, topic: str) -> list[dict[str, object]]:
    """The subscriptions of a topic that arrived."""
    return [one for one in site.server.bridge.received if one["op"] == "subscribe" and one["topic"] == topic]


def off(robot: Robot, true: Pose) -> float:
    """Metres between the place of a robot as the console has it, and the true one."""
    assert robot.pose is not None
    return math.dist((robot.pose.value.x, robot.pose.value.y), (true.x, true.y))


async def test_one_topic_tells_the_places_of_several_robots_by_their_prefixes(site: Site) -> None:
    play(site.server, [("tf-only", R0), ("tf-only", R1)])
    async with linked(site.config) as (link, store):
        state = await store.until(nav2_ready)
        for name in (R0, R1):
            assert off(state.robots[name], site.navigation(name).robot.pose) < 0.05
        record = await finished(link, store, site.to("Receiving"))
        ended = await reached(store, record.id, Stage.DONE)
        assert ended.stage is Stage.DONE
        end = site.navigation().robot.pose
        await store.until(lambda state: off(state.robots[R0], end) < 0.05)
    (asked,) = asked_for(site, "/tf")
    assert (asked["throttle_rate"], asked["compression"]) == (0, "cbor")


async def test_a_robot_has_transforms_of_its_own_in_its_namespace(site: Site) -> None:
    play(site.server, [("own-tf", R0), ("own-tf", R1)])
    async with linked(with_topics(site.config, tf="/{robot}/tf")) as (_, store):
        state = await store.until(nav2_ready)
        for name in (R0, R1):
            assert off(state.robots[name], site.navigation(name).robot.pose) < 0.05


async def test_transforms_are_asked_for_only_where_no_localisation_has_a_topic(site: Site) -> None:
    play(site.server, [("own-tf", R1)])
    async with linked(with_topics(site.config, tf="/{robot}/tf")) as (_, store):
        await store.until(nav2_ready)
    assert asked_for(site, f"/{R1}/tf") and not asked_for(site, f"/{R0}/tf")


async def test_a_robot_drives_by_its_transforms_though_its_odometry_has_a_topic_of_another_frame(
    site: Site,
) -> None:
    """Raw wheels on the topic, fused ones in the transforms: mixed, they place a robot nowhere."""
    play(site.server, [("tf-only", R0), ("tf-only", R1)])
    robot = site.navigation().robot
    robot.belief.place(robot.pose.after(Pose(3.0, 0.0)), robot.pose)

    def follows(state: FleetState) -> bool:
        return nav2_ready(state) and off(state.robots[R0], robot.belief.of(robot.pose)) < 0.05

    async with linked(site.config) as (_, store):
        await store.until(follows)
        assert store.state.robots[R0].located_by == "transforms"
