"""Topics of robots with Nav2."""

import json
import math

from websockets.asyncio.client import ClientConnection

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import flat
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.nav2_client import TO_POSE, listen, settle, statuses, until

STATUS = f"{TO_POSE}/_action/status"
LATCHED = {"durability": "transient_local", "reliability": "reliable", "history": "keep_last", "depth": 1}


async def test_statuses_are_told_to_late_subscribers_and_not_before_the_first_goal(
    client: ClientConnection, fleet: Nav2Fleet
) -> None:
    ask = {"op": "subscribe", "topic": STATUS, "type": "action_msgs/msg/GoalStatusArray", "qos": LATCHED}
    await client.send(json.dumps(ask))
    await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
    assert json.loads(await client.recv())["id"] == "x"
    fleet.navigation["robot_0"].give(8.0, 0.0)
    assert statuses(await until(client, lambda frame: frame.get("topic") == STATUS)) == [1]
    await until(client, lambda frame: statuses(frame) == [4])
    await client.send(json.dumps({"op": "unsubscribe", "topic": STATUS}))
    await client.send(json.dumps(ask))
    assert statuses(json.loads(await client.recv())) == [4]


async def test_odometry_starts_at_nothing_and_leaves_unmeasured_what_it_cannot_measure(
    client: ClientConnection,
) -> None:
    await listen(client, "/robot_0/odom")
    text = str(await client.recv())
    message = json.loads(text)["msg"]
    assert message["header"]["frame_id"] == "robot_0/odom"
    assert message["pose"]["pose"]["position"] == {"x": 0.0, "y": 0.0, "z": 0.0}
    assert ",NaN," in text and math.isnan(message["pose"]["covariance"][21])


async def test_a_place_is_the_last_localisation_and_what_the_wheels_counted_since(
    client: ClientConnection, fleet: Nav2Fleet
) -> None:
    for topic in ("amcl_pose", "odom"):
        await listen(client, f"/robot_0/{topic}")
    robot = fleet.robots["robot_0"]
    fleet.navigation["robot_0"].give(35.0, 20.0)
    newest: dict[str, Pose] = {}
    then = anchor = Pose(0.0, 0.0)
    worst = 0.0
    while robot.driving:
        frame = json.loads(await client.recv())
        topic = frame["topic"].rpartition("/")[2]
        newest[topic] = flat(frame["msg"]["pose"]["pose"])
        if topic == "amcl_pose":
            then, anchor = newest.get("odom", Pose(0.0, 0.0)), newest[topic]
        elif topic in newest:
            now = newest["odom"]
            turn = anchor.yaw - then.yaw
            dx, dy = now.x - then.x, now.y - then.y
            x = anchor.x + dx * math.cos(turn) - dy * math.sin(turn)
            y = anchor.y + dx * math.sin(turn) + dy * math.cos(turn)
            worst = max(worst, math.dist((x, y), (robot.pose.x, robot.pose.y)))
    # A tick of 0.02 s at twenty times the speed is 0.44 m, and the two are a tick apart.
    assert 0.0 < worst < 1.5


async def test_the_last_robot_does_not_measure_its_battery(client: ClientConnection) -> None:
    told = {}
    for robot in ("robot_0", "robot_1"):
        await listen(client, f"/{robot}/battery_state")
        frame = await until(client, lambda frame: "msg" in frame)
        told[robot] = frame["msg"]["percentage"]
        await client.send(json.dumps({"op": "unsubscribe", "topic": f"/{robot}/battery_state"}))
    assert 0.4 < told["robot_0"] < 1.0 and told["robot_1"] is None


async def test_the_collision_monitor_speaks_only_on_change(
    client: ClientConnection, fleet: Nav2Fleet
) -> None:
    topic = "/robot_0/collision_monitor_state"
    await listen(client, topic)
    await settle(client)
    fleet.navigation["robot_0"].give(20.0, 0.0)
    fleet.robots["robot_0"].block()
    stopped = json.loads(await client.recv())
    assert stopped["msg"] == {"action_type": 1, "polygon_name": "PolygonStop"}
    fleet.robots["robot_0"].obstacle = 0.0
    assert json.loads(await client.recv())["msg"] == {"action_type": 0, "polygon_name": ""}


async def test_several_floors_have_a_map_each_and_robots_tell_theirs() -> None:
    server = RosbridgeServer(Nav2Fleet(2, 2, seed=1, quiet=True), dialect=ROS2)
    types = server.bridge.services.types
    assert types["/floor_1/map"] == "nav_msgs/msg/OccupancyGrid" and "/map" not in types
    assert json.loads(server.bridge.topics["/robot_1/floor"].payload(0.0).json) == {"data": "floor_1"}
    frame = json.loads(server.bridge.topics["/floor_1/map"].payload(0.0).json)
    assert frame["header"]["frame_id"] == "map"
