"""Robots of which only transforms tell the place, as with slam_toolbox: no localisation has a topic."""

import time
from typing import TYPE_CHECKING

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import FRAME, Topic, solid
from fleet_tui.simulator.senses.laser import TRANSFORMS

if TYPE_CHECKING:
    from fleet_tui.simulator.navigating.robot import NavigatingRobot
    from fleet_tui.simulator.server import RosbridgeServer

LOCALISED_HZ = 20.0
COUNTED_HZ = 50.0
"""Transforms a second of the localisation and of the wheels: two publishers of one topic."""
TOLERANCE = 1.0
"""Seconds by which a localisation stamps its transform ahead, so that it is valid until the next one."""


def publish(server: "RosbridgeServer", robot: "NavigatingRobot", topic: str, prefix: str) -> None:
    """Withdraw the topic of a robot's localisation, and publish its transforms on `topic` from now on;
    `prefix` is before the names of its own frames."""
    bridge, nothing = server.bridge, Payload({"transforms": []})
    bridge.withdraw(f"/{robot.name}/amcl_pose")
    bridge.advertise(Topic(topic, bridge.dialect.message_type(TRANSFORMS), lambda _now: nothing))
    age = localised = counted = 0.0

    def send(parent: str, child: str, pose: Pose, ahead: float = 0.0) -> None:
        placed, header = solid(pose), bridge.dialect.header(0, time.time() + ahead, parent)
        moved = {"translation": placed["position"], "rotation": placed["orientation"]}
        transform = {"header": header, "child_frame_id": f"{prefix}{child}", "transform": moved}
        bridge.publish(topic, Payload({"transforms": [transform]}))

    def step(dt: float) -> None:
        nonlocal age, localised, counted
        age += dt / server.speed
        while localised < age * LOCALISED_HZ:
            localised += 1
            if not (robot.silence or robot.is_unlocalised):
                origin = robot.belief.of(robot.pose).after(robot.odom.inverse)
                send(FRAME, "odom", origin, TOLERANCE)
        while counted < age * COUNTED_HZ:
            counted += 1
            if not robot.silence:
                send(f"{prefix}odom", "base_footprint", robot.odom)

    bridge.services.fleet_of(robot.name).troubles.append(step)
