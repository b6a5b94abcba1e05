"""Goals through the bridge, and what other clients see and may do of them."""

import json
from pathlib import Path

import pytest
from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.graph_files import write_graphs
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
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


async def test_waypoints_end_with_what_was_missed(client: ClientConnection, fleet: Nav2Fleet) -> None:
    await give(client, "w", WAYPOINTS, poses=[pose(-99.0, 0.0), pose(8.0, 0.0)])
    answer = await result(client, "w")
    assert list(answer["values"]) == ["missed_waypoints", "error_code", "error_msg"]
    (missed,) = answer["values"]["missed_waypoints"]
    assert (answer["status"], missed["index"], missed["error_code"]) == (4, 0, 204)
    assert list(missed["goal"]) == ["header", "pose"]


async def test_fleets_of_several_kinds_share_a_bridge() -> None:
    fleets: list[Fleet] = [OhFleet(2, 1, seed=1, quiet=True), Nav2Fleet(1, 1, seed=1, quiet=True, first=2)]
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


async def test_a_route_server_takes_a_graph_by_the_path_of_its_file(
    client: ClientConnection, fleet: Nav2Fleet, tmp_path: Path
) -> None:
    (file,) = write_graphs(tmp_path / "routes.geojson", 1)
    service = "/robot_1/route_server/set_route_graph"
    assert await call(client, service, graph_filepath=str(file)) == {"success": True}
    assert await call(client, service, graph_filepath=str(tmp_path)) == {"success": False}
    assert fleet.route_servers.graphs.keys() == {"robot_1"}
