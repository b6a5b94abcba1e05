"""Faults of robots that navigate, whichever stack they run."""

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from fleet_tui.simulator.faults import camera, hand
from fleet_tui.simulator.faults.plays import (
    FLAT,
    Faults,
    Play,
    battery,
    each_step,
    having,
    obstacle,
    robot_of,
)
from fleet_tui.simulator.senses.belief import DRIFT

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.model.geometry import Pose
    from fleet_tui.simulator.navigating.robot import NavigatingRobot
    from fleet_tui.simulator.navigating.world import Navigating
    from fleet_tui.simulator.server import RosbridgeServer

    N = TypeVar("N", bound=Navigating)
else:
    N = TypeVar("N")

AWHILE = 3.0  # seconds after which something happens to a drive
LOCALISED_HZ = 20.0
COUNTED_HZ = 50.0
"""Transforms a second of the localisation and of the wheels: two publishers of one topic."""
TOLERANCE = 1.0
"""Seconds by which a localisation stamps its transform ahead, so that it is valid until the next one."""
EVERY = 20.0  # seconds between two goals of another client


def navigation_of(server: "RosbridgeServer", robot: str) -> Any:
    from fleet_tui.simulator.navigating.world import NavigatingWorld

    fleet = server.bridge.services.fleet_of(robot)
    assert isinstance(fleet, NavigatingWorld)
    return fleet.navigation[robot]


def often(act: Callable[[N], None], seconds: float | None = None, idle: bool = False) -> Play:
    """Return a recurring fault: it occurs `seconds`, or else AWHILE, after a goal began, and after it
    occurred last; if `idle` without a goal, too."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        navigation, age = navigation_of(server, robot), 0.0

        def step(passed: float) -> None:
            nonlocal age
            age = age + passed if idle or navigation.busy else 0.0
            if age >= (AWHILE if seconds is None else seconds):
                age = 0.0
                act(navigation)

        each_step(server, robot, step)

    return play


def _foreign_goal(navigation: "Navigating") -> None:
    floor, at = navigation.robot.floor, navigation.robot.pose
    far = max(floor.labels, key=lambda id_: abs(floor.graph.vertices[id_].x - at.x))
    navigation.give(floor.graph.vertices[far].x, floor.graph.vertices[far].y)


def _foreign_cancel(navigation: "Navigating") -> None:
    navigation.cancel_all()


def _lost(server: "RosbridgeServer", robot: str) -> None:
    robot_of(server, robot).lose()


def _mislocalised(server: "RosbridgeServer", robot: str) -> None:
    """Let it believe to be elsewhere: the published pose follows at once."""
    body: NavigatingRobot = robot_of(server, robot)
    body.place(body.pose.after(DRIFT))


def unlocalised(server: "RosbridgeServer", robot: str) -> None:
    """Kill the node of its localisation during the first goal."""

    def die(navigation: "Navigating") -> None:
        if not navigation.robot.is_unlocalised:
            navigation.robot.is_unlocalised = True
            navigation.robot.localised_last = navigation.robot.pose, time.time()
            if (topic := f"/{robot}/amcl_pose") in server.bridge.topics:
                server.bridge.withdraw(topic)

    often(die)(server, robot)


def shared_transforms(server: "RosbridgeServer", robot: str) -> None:
    """Publish transforms on a topic of all robots, instead of a pose."""
    _transforms(server, robot, "/tf", f"{robot}/")


def own_transforms(server: "RosbridgeServer", robot: str) -> None:
    """Publish transforms in its own namespace, instead of a pose."""
    _transforms(server, robot, f"/{robot}/tf", "")


def _transforms(server: "RosbridgeServer", name: str, topic: str, prefix: str) -> None:
    """Withdraw the topic of its localisation, which slam_toolbox lacks, and publish transforms on `topic`;
    `prefix` is before the names of its own frames."""
    from fleet_tui.simulator.frames import Payload
    from fleet_tui.simulator.messages import FRAME, Topic, solid
    from fleet_tui.simulator.senses.laser import TRANSFORMS

    robot: NavigatingRobot = robot_of(server, name)
    bridge, nothing = server.bridge, Payload({"transforms": []})
    bridge.withdraw(f"/{name}/amcl_pose")
    bridge.advertise(Topic(topic, bridge.dialect.message_type(TRANSFORMS), lambda _now: nothing))
    age = localised = counted = 0.0

    def send(parent: str, child: str, pose: "Pose", ahead: float = 0.0) -> None:
        placed, header = solid(pose), bridge.dialect.header(0, time.time() + ahead, parent)
        moved = {"translation": placed["position"], "rotation": placed["orientation"]}
        transform = {"header": header, "child_frame_id": f"{prefix}{child}", "transform": moved}
        bridge.publish(topic, Payload({"transforms": [transform]}))

    def step(passed: float) -> None:
        nonlocal age, localised, counted
        age += passed
        while localised < age * LOCALISED_HZ:
            localised += 1
            if not (robot.silence or robot.is_unlocalised):
                origin = robot.belief.of(robot.pose).after(robot.odom.inverse)
                send(FRAME, "odom", origin, TOLERANCE)
        while counted < age * COUNTED_HZ:
            counted += 1
            if not robot.silence:
                send(f"{prefix}odom", "base_footprint", robot.odom)

    each_step(server, name, step)


BODY: Faults = {
    "tf-only": (
        "no pose topic: the transforms on /tf tell its place, as with slam_toolbox",
        shared_transforms,
    ),
    "own-tf": ("the same with transforms of its own, on /{robot}/tf", own_transforms),
    "dead-localisation": (
        f"its localisation dies {AWHILE:g} s after the first goal, its wheels count on",
        unlocalised,
    ),
    "stuck": ("wheels blocked: recoveries, then an abort", having(robot_of, stuck=True)),
    "foreign-goal": (
        f"another client sends a goal every {EVERY:g} s",
        often(_foreign_goal, EVERY, idle=True),
    ),
    "foreign-cancel": (f"another client cancels every goal after {AWHILE:g} s", often(_foreign_cancel)),
    "no-odom": ("no odometry", having(robot_of, odometry=False)),
    "lost": ("localisation uncertain and wrong", _lost),
    "mislocalised": ("believes to be 4 m away and turned, until its pose is set", _mislocalised),
    "obstacle": ("stops at a permanent obstacle", obstacle),
    "battery": (f"battery never above {FLAT:g} %", battery),
    "unmeasured": ("battery percentage NaN", having(robot_of, percent=float("nan"))),
    "percent": ("battery percentage 0 to 100 instead of 0 to 1", having(robot_of, percent=1.0)),
    "silent": ("sends nothing", having(robot_of, silence=float("inf"))),
    **hand.FAULTS,
    **camera.FAULTS,
}
