"""Goals through the bridge, and what other clients see and may do of them."""

import asyncio
import json
import math

import pytest
from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.navigating.poses import flat
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.ros.goals import CANCELED, EXECUTING
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.nav2_client import (
    TO_POSE,
    WAYPOINTS,
    ZERO,
    Json,
    call,
    give,
    listen,
    pose,
    result,
    settle,
    statuses,
    until,
)

STATUS = f"{TO_POSE}/_action/status"
CANCEL = f"{TO_POSE}/_action/cancel_goal"
LATCHED = {"durability": "transient_local", "reliability": "reliable", "history": "keep_last", "depth": 1}


async def test_a_replaced_goal_ends_aborted_before_the_new_one(client: ClientConnection) -> None:
    await give(client, "a", TO_POSE, pose=pose(35.0, 20.0))
    await give(client, "b", TO_POSE, pose=pose(8.0, 0.0))
    first, second = await result(client, "a"), await result(client, "b")
    assert (first["status"], first["result"], second["status"]) == (6, True, 4)


async def test_anyone_cancels_by_the_id_that_the_status_tells(
    client: ClientConnection, other: ClientConnection
) -> None:
    await listen(other, STATUS)
    await settle(other)
    await give(client, "a", TO_POSE, pose=pose(35.0, 20.0))
    info = (await until(other, lambda frame: "msg" in frame))["msg"]["status_list"][0]["goal_info"]
    answer = await call(other, CANCEL, goal_info={**info, "stamp": {"sec": 0, "nanosec": 0}})
    assert answer == {"return_code": 0, "goals_canceling": [info]}
    assert (await result(client, "a"))["status"] == CANCELED
    assert (await call(other, CANCEL, goal_info=info | {"stamp": {}}))["return_code"] == 3


@pytest.mark.parametrize("args", [{}, {"goal_info": {"goal_id": {"uuid": ZERO}}}])
async def test_no_id_means_all_goals(client: ClientConnection, fleet: Nav2Fleet, args: Json) -> None:
    goal = fleet.navigation["robot_0"].give(35.0, 20.0)
    assert goal is not None
    assert len((await call(client, CANCEL, **args))["goals_canceling"]) == 1
    assert (await call(client, CANCEL, **args)) == {"return_code": 0, "goals_canceling": []}


async def test_a_stamp_alone_means_all_up_to_it(client: ClientConnection, fleet: Nav2Fleet) -> None:
    goal = fleet.navigation["robot_0"].give(35.0, 20.0)
    assert goal is not None
    for off, meant in ((-1, 0), (0, 1)):
        sec, nanosec = divmod(goal.stamp + off, 10**9)
        answer = await call(client, CANCEL, goal_info={"stamp": {"sec": sec, "nanosec": nanosec}})
        assert (answer["return_code"], len(answer["goals_canceling"])) == (0, meant)


@pytest.mark.parametrize(
    "wrong", [{"stamp": {"sec": "x"}}, {"goal_id": {"uuid": 7}}, {"goal_id": {"uuid": "?"}}]
)
async def test_a_cancel_with_a_wrong_field_is_refused(
    client: ClientConnection, fleet: Nav2Fleet, wrong: Json
) -> None:
    goal = fleet.navigation["robot_0"].give(35.0, 20.0)
    answer = await call(client, CANCEL, goal_info=wrong)
    assert isinstance(answer, str) and goal is not None and goal.status == EXECUTING


async def test_the_senders_connection_alone_cancels_by_its_own_id(
    server: RosbridgeServer, client: ClientConnection, fleet: Nav2Fleet
) -> None:
    async with connect(server.url, close_timeout=0.1) as sender:
        await give(sender, "a", TO_POSE, pose=pose(35.0, 20.0))
        await settle(sender)
        await client.send(json.dumps({"op": "cancel_action_goal", "id": "a", "action": TO_POSE}))
        await settle(client)
        (goal,) = fleet.actions[TO_POSE].running
    assert goal.status == EXECUTING
    async with asyncio.timeout(5):
        while not goal.over:  # its sender is gone, it goes on
            await settle(client)
    assert goal.status == 4


async def test_a_pose_that_is_published_becomes_a_goal(
    client: ClientConnection, other: ClientConnection
) -> None:
    await listen(other, STATUS)
    await settle(other)
    await client.send(json.dumps({"op": "publish", "topic": "/robot_0/goal_pose", "msg": pose(8.0, 0.0)}))
    assert statuses(json.loads(await other.recv())) == [1]
    types = await call(client, "/rosapi/topic_type", topic="/robot_0/goal_pose")
    assert types == {"type": "geometry_msgs/msg/PoseStamped"}
    assert await call(client, "/rosapi/subscribers", topic="/robot_0/goal_pose") == {
        "subscribers": ["/fleet"]
    }


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


async def test_waypoints_end_with_what_was_missed(client: ClientConnection, fleet: Nav2Fleet) -> None:
    await give(client, "w", WAYPOINTS, poses=[pose(-99.0, 0.0), pose(8.0, 0.0)])
    answer = await result(client, "w")
    assert list(answer["values"]) == ["missed_waypoints", "error_code", "error_msg"]
    (missed,) = answer["values"]["missed_waypoints"]
    assert (answer["status"], missed["index"], missed["error_code"]) == (4, 0, 204)
    assert list(missed["goal"]) == ["header", "pose"]


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


async def test_fleets_of_several_kinds_share_a_bridge() -> None:
    fleets: list[Fleet] = [
        OhFleet(World(2, 1, seed=1, quiet=True)),
        Nav2Fleet(1, 1, seed=1, quiet=True, first=2),
    ]
    server = RosbridgeServer(fleets, speed=20.0, dialect=ROS2)
    assert list(server.bridge.services.robots) == ["robot_0", "robot_1", "robot_2"]
    await server.start()
    async with connect(server.url, close_timeout=0.1) as client:
        answer = await call(client, "/robot_2/lifecycle_manager_navigation/is_active")
        assert answer == {"success": True, "message": ""}
        assert (await call(client, "/robot_0/Application_layout/Pause"))["success"]
        await client.send(
            json.dumps(
                {"op": "send_action_goal", "id": "a", "action": "/robot_2/navigate_to_pose"}
                | {"action_type": "nav2_msgs/NavigateToPose", "args": {"pose": pose(8.0, 0.0)}}
            )
        )
        assert (await result(client, "a"))["status"] == 4
    await server.stop()
    assert server.world.robots["robot_0"].paused


async def test_a_bridge_of_ros_1_knows_no_goals() -> None:
    server = RosbridgeServer(World(1, 1, seed=1, quiet=True))
    await server.start()
    async with connect(server.url, close_timeout=0.1) as client:
        await give(client, "a", TO_POSE, pose=pose(8.0, 0.0))
        await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
        assert json.loads(await client.recv())["id"] == "x"
    await server.stop()
