"""Questions to rosapi: few, and never many at once."""

import math
from collections import Counter

from fleet_tui.links.discovery.facts import RosapiFacts
from fleet_tui.links.discovery.questions import listed_by
from fleet_tui.links.discovery.rosapi import AT_ONCE_ROS1
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.asked_rosapi import AskedRosapi, CountedQuestions
from tests.support.discovering import discovered


async def test_a_bridge_with_two_thousand_topics_is_neither_flooded_nor_asked_for_minutes(
    server: RosbridgeServer,
) -> None:
    server.bridge.services.types |= {f"/thing_{n % 37}/part_{n}": "std_msgs/String" for n in range(2000)}
    questions, slow = CountedQuestions(0.002), ("publishers", "service_type")
    server.bridge.services.deliveries |= {f"/rosapi/{one}": questions.deliver for one in slow}
    progress: list[tuple[int, int, str]] = []
    found = await discovered(server.url, progress)
    asked = Counter(one.get("service") for one in server.bridge.received)
    assert asked["/rosapi/publishers"] <= 300 and asked["/rosapi/service_type"] <= 100
    assert questions.most <= AT_ONCE_ROS1
    assert found.summary == "2 robots (oh_ressources), 2 floors"
    counted = [(done, total) for done, total, doing in progress if doing == "looking up publishers"]
    assert counted[-1][0] == counted[-1][1] <= 300


async def test_topics_without_a_publisher_are_left_out_and_every_service_gets_a_type() -> None:
    pose, queue = "geometry_msgs/PoseStamped", "OH_ressources/ActionQueue"
    topics = {
        f"/robot_{n}/{name}": type_ for n in range(9) for name, type_ in (("pose", pose), ("queue", queue))
    }
    services = {f"/robot_{n}/Application_layout/Pause": None for n in range(9)}
    wire = AskedRosapi(
        publishers=lambda args: {"publishers": ["/n"] if "robot_3" not in args["topic"] else []},
        service_type=lambda _: {"type": "std_srvs/Trigger"},
    )
    told: list[tuple[int, int, str]] = []
    listed, rosapi = await listed_by(
        wire.wire, RosapiFacts(topics, services, ros=1), math.inf, lambda *progress: told.append(progress)
    )
    assert listed.topics == {name: type_ for name, type_ in topics.items() if "robot_3" not in name}
    assert rosapi.topics == listed.topics
    assert listed.services == dict.fromkeys(services, "std_srvs/Trigger")
    assert sum(name == "service_type" for name, _ in wire.asked) < len(services), (
        "of robots alike, one is asked"
    )
    assert told[-1][2] == "looking up service types" and told[-1][0] == told[-1][1]
