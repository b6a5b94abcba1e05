"""A real move_base of ROS 1 without a namespace, as recorded: what the console makes of its goals, and what
the simulated one says in its place."""

import json
from typing import Any

from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config, Link
from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import Stage
from fleet_tui.model.events import GridReceived
from fleet_tui.robots.adapter import Feed, Limit
from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.move_base.discovery import STATUS_TYPE, discover
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.move_base.navigation import NO_PLAN
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import WireError
from tests.support.fleets import LINK, R0, T0, link_up, recording, reduced, tick
from tests.support.move_base_client import publish
from tests.support.nav2_client import listen, settle
from tests.support.transcripts import shape

RECORDED = "ros1-move-base.jsonl.gz"
NODE = "/move_base"
TOLD = ("goal", "current_goal", "status", "feedback", "result", "NavfnROS/plan")
"""What a drive publishes, below its node."""


def no_map(_profile: Profile, _feed: Feed, _payload: bytes) -> GridReceived:
    raise WireError("no map here")


def test_each_recorded_goal_ends_as_its_result_says() -> None:
    found = discover(Listed({f"{NODE}/status": STATUS_TYPE}, {}, ()))
    config = Config(
        rosbridge=Link("ws://site:9090"),
        floors=[FloorEntry("floor_0")],
        robots=[RobotEntry(R0)],
        profile=Profile(
            kind="move_base", topics=found.topics, services=found.services, actions=found.actions
        ),
    )
    adapters = adapters_of(config)
    reader = FrameReader(LINK, Limit(64.0, ""), adapters, feeds_of(config, adapters, LINK), no_map, print)
    state = reduced(initial_state(config, T0), link_up(T0))
    ends: dict[str, tuple[Stage, str]] = {}
    for line in recording(RECORDED):
        at = T0 + line["t"]
        read = reader.read(line["text"].encode(), False, at)
        state = reduced(state, *(read if isinstance(read, tuple) else ()), tick(at))
        ends |= {one.order.id: (one.stage, one.reason) for one in state.robots[R0].gone if one.is_reported}
    assert [stage for stage, _ in ends.values()] == [
        *(Stage.DONE, Stage.DONE, Stage.DONE, Stage.FAILED, Stage.REPLACED, Stage.FAILED),
        *(Stage.CANCELLED, Stage.DONE, Stage.CANCELLED),
    ]
    told = {reason for stage, reason in ends.values() if stage is Stage.FAILED}
    assert told == {NO_PLAN}


async def test_a_simulated_drive_is_told_in_the_messages_of_the_recorded_one() -> None:
    frames = [json.loads(line["text"]) for line in recording(RECORDED)]
    server = RosbridgeServer(MoveBaseFleet(1, 1, seed=1, quiet=True), rate=50.0, speed=5.0)
    await server.start()
    try:
        async with connect(server.url) as client, connect(server.url) as other:
            given = next(one["msg"] for one in frames if one["topic"] == f"{NODE}/goal")
            given["goal"]["target_pose"]["pose"]["position"] = {"x": 8.0, "y": 0.0, "z": 0.0}
            seen = await _driven(client, other, given)
    finally:
        await server.stop()
    for part in TOLD:
        real = (one["msg"] for one in frames if one["topic"] == f"{NODE}/{part}")
        assert shape(seen[part]) in [shape(msg) for msg in real], part
    first = next(one["msg"] for one in frames if one["topic"] == f"{NODE}/goal")
    assert seen["goal"]["header"] == first["header"]


async def _driven(client: ClientConnection, other: ClientConnection, goal: dict[str, Any]) -> dict[str, Any]:
    """Give a goal, and return the last message of each topic until its end."""
    for part in TOLD:
        await listen(other, f"/{R0}{NODE}/{part}")
    await settle(other)
    await publish(client, f"/{R0}{NODE}/goal", goal)
    seen: dict[str, Any] = {}
    while "result" not in seen:
        frame = json.loads(await other.recv())
        seen[frame["topic"].removeprefix(f"/{R0}{NODE}/")] = frame["msg"]
    return seen
