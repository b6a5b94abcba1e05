"""A recording of a real bridge as the oracle: on an ordinary site nothing is late, silent or old."""

import json

from fleet_tui.adapters.adapter import Feed, Limit
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.ros.reading import FrameReader
from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config, Link
from fleet_tui.config.start import initial_state
from fleet_tui.errors import WireError
from fleet_tui.model.events import GridReceived
from fleet_tui.situation.links import late_link
from fleet_tui.situation.robots import bad_data, is_unreadable, silent
from tests.support.fleets import LINK, T0, link_up, recording, reduced, tick

ROBOT = "robot_1"


def no_map(_profile: Profile, _feed: Feed, _payload: bytes) -> GridReceived:
    raise WireError("no map here")


def test_a_real_robot_is_online_and_its_pose_fresh_from_its_second_message_on() -> None:
    config = Config(
        rosbridge=Link("ws://site:9090"),
        floors=[FloorEntry("ground"), FloorEntry("first")],
        robots=[RobotEntry(ROBOT)],
    )
    adapters = adapters_of(config)
    reader = FrameReader(LINK, Limit(64.0, ""), adapters, feeds_of(config, adapters, LINK), no_map, print)
    state = reduced(initial_state(config, T0), link_up(T0))
    poses, ticked = 0, T0
    for line in recording("telemetry-and-orders.jsonl"):
        at = T0 + line["t"]
        while ticked < at:
            state, ticked = reduced(state, tick(ticked)), ticked + 0.1
        if line["dir"] == "out" or "text" not in line:
            continue
        read = reader.read(line["text"].encode(), False, at)
        state = reduced(state, *(read if isinstance(read, tuple) else ()))
        frame = json.loads(line["text"]) if line["text"].startswith("{") else {}
        poses += frame.get("topic") == f"/{ROBOT}/pose"
        robot, link = state.robots[ROBOT], state.links[LINK]
        assert silent(state, robot) is None and late_link(state, link) is None
        assert bad_data(state, robot) is None and not is_unreadable(state, robot)
        if poses >= 2 and at - T0 < 18.0:
            assert state.is_online(robot) and state.is_fresh(robot, "pose"), line["t"]
            assert robot.pose is not None and at - robot.pose.at < 0.5
    assert poses > 100 and not any(alarm.holds for alarm in state.alarms)
