"""The place of the laser on every simulated robot, and the static frames that tell it."""

import math
from collections.abc import Iterable, Iterator

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Message, Topic
from fleet_tui.simulator.ros.dialect import Dialect

TOPIC = "/tf_static"
TYPE = "tf2_msgs/TFMessage"
MOUNT = Pose(0.2, 0.05, math.pi / 18)
"""Left of the middle of the front, turned to the left."""


def frames_topic(robots: Iterable[str], loaded_at: float, dialect: Dialect) -> Topic:
    """The static frames of all robots. Each has its own publisher, whose message late subscribers get."""
    payloads = [Payload({"transforms": list(_frames(robot, loaded_at, dialect))}) for robot in robots]
    nothing = Payload({"transforms": []})
    type_ = dialect.message_type(TYPE)
    return Topic(TOPIC, type_, lambda _: nothing, latched=True, history=lambda: payloads)


def _frames(robot: str, at: float, dialect: Dialect) -> Iterator[Message]:
    for parent, child, pose, height in (
        ("base_footprint", "base_link", Pose(0.0, 0.0), 0.1),
        ("base_link", "laser", MOUNT, 0.25),
    ):
        half = pose.yaw / 2.0
        yield {
            "header": dialect.header(0, at, f"{robot}/{parent}"),
            "child_frame_id": f"{robot}/{child}",
            "transform": {
                "translation": {"x": pose.x, "y": pose.y, "z": height},
                "rotation": {"x": 0.0, "y": 0.0, "z": math.sin(half), "w": math.cos(half)},
            },
        }
