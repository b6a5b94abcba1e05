"""Set-up commands as messages and calls."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, assert_never

from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import (
    CAMERA,
    DRIVE,
    GOAL,
    GOAL_CANCEL,
    LOCALISE,
    MAPPING,
    PATH,
    POSE,
    SCAN,
    SETTLE,
    noun_of,
)
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up import commands
from fleet_tui.robots.adapter import Feed, Outgoing, Publication, ServiceCall, Site
from fleet_tui.robots.probes import ListenerProbe, ServiceProbe
from fleet_tui.robots.ros.facts import is_place
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros.set_up.frames import read_frames
from fleet_tui.robots.ros.set_up.names import STAMPED_TWIST
from fleet_tui.robots.ros.set_up.saving import KEYS, load_request, save_request
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import StreamValue

XY = 0.25
YAW = (math.pi / 12) ** 2
"""RViz's variances of a pose set by hand: square metres of x and of y, square radians."""
ALL_GOALS: Mapping[str, object] = {"stamp": {"secs": 0, "nsecs": 0}, "id": ""}
"""The cancellation of every goal: one that was sent as a pose has an id of the robot's own."""
RATES_MS = {SCAN: 200, PATH: 1000, CAMERA: 500}
"""Milliseconds between two messages of a stream."""
MOST_PUBLISHERS = 100
"""Publishers of static frames, each with one message that counts."""


def solid(pose: Pose) -> Mapping[str, object]:
    """Return a geometry_msgs/Pose, its quaternion of unit length. Raises CommandError for a pose on no
    map."""
    if not is_place(pose.x, pose.y) or not math.isfinite(pose.yaw):
        raise CommandError(Message("the pose is not finite"))
    half = math.remainder(pose.yaw, math.tau) / 2
    return {
        "position": {"x": pose.x, "y": pose.y, "z": 0.0},
        "orientation": {"x": 0.0, "y": 0.0, "z": math.sin(half), "w": math.cos(half)},
    }


class SetUpRequests:
    """The set-up of one site's robots, as far as its profile names topics and services for it."""

    def __init__(self, names: Names, site: Site, frames_are_floors: bool) -> None:
        """`frames_are_floors`: the frame of a pose names its floor; otherwise it is that of the robot's own
        poses, and goals are orders."""
        self._names = names
        self._site = site
        self._frames_are_floors = frames_are_floors
        table = names.table
        keys = {POSE: "topics.initial_pose", LOCALISE: "services.localise", SETTLE: "services.settle"}
        keys[DRIVE] = "topics.drive"
        there = names.vocabulary.services
        keys |= {ability: f"services.{key}" for ability, key in KEYS.items() if key in there}
        if frames_are_floors:
            keys |= {GOAL: "topics.goal", GOAL_CANCEL: "topics.goal_cancel"}
        self._keys = {ability: f"{table}.{key}" for ability, key in keys.items()}
        self.streams = tuple(key for key in RATES_MS if self._stream_topic(key, "robot"))
        """The streams that can be watched."""

    @property
    def accepted(self) -> tuple[str, ...]:
        """Return the set-up requests that such robots accept."""
        there = [ability for ability, key in self._keys.items() if self._named(key.rpartition(".")[2])]
        return (*there, MAPPING) if self._named("mapping_on") and self._named("mapping_off") else (*there,)

    @property
    def unset(self) -> dict[str, str]:
        """Return by request or stream that is not accepted the key of the profile that is empty."""
        table, accepted = self._names.table, self.accepted
        missing = {ability: key for ability, key in self._keys.items() if ability not in accepted}
        missing |= {key: f"{table}.topics.{key}" for key in RATES_MS if key not in self.streams}
        if MAPPING not in accepted:
            key = "mapping_off" if self._named("mapping_on") else "mapping_on"
            missing[MAPPING] = f"{table}.services.{key}"
        return missing

    def _named(self, key: str) -> bool:
        names = self._names
        named = names.topic if key in names.vocabulary.topics else names.service
        return bool(named(key, "robot"))

    def _stream_topic(self, key: str, robot: str) -> str:
        """Return the topic of a stream. The path of a kind whose goals have a plan is that plan."""
        names = self._names
        own = names.topic(key, robot)
        is_plan = key == PATH and "plan" in names.vocabulary.topics
        return own or (names.topic("plan", robot) if is_plan else "")

    def feeds(self, robot: str) -> Iterator[Feed]:
        """Return the mode, and the streams. A path that is the plan of a goal has its feed already."""
        names = self._names
        if topic := names.topic("mode", robot):
            yield Feed("mode", (robot,), "", topic, names.type("mode"), latched=True, silent=True)
        plan = names.topic("plan", robot) if "plan" in names.vocabulary.topics else ""
        for key, rate in RATES_MS.items():
            topic = names.topic(key, robot)
            if topic and topic != plan:
                yield Feed(key, (robot,), "", topic, names.type(key), rate, wanted_for="stream", silent=True)
        if names.topic(SCAN, robot) and (topic := names.topic("tf_static", robot)):
            # Each publisher of frames sends one latched message: the newest alone is not enough.
            frames = Feed(
                "tf_static", (robot,), "", topic, names.type("tf_static"), queue_length=MOST_PUBLISHERS
            )
            yield frames._replace(latched=True, silent=True, wanted_for="stream", is_shared=True)

    def probes(self, robot: str) -> Iterator[ListenerProbe | ServiceProbe]:
        """Return the topics and services of set-up that must have a node at their other end."""
        names, services = self._names, dict[str, ServiceProbe]()
        named = [(ability, *key.split(".")[-2:]) for ability, key in self._keys.items()]
        named += [(MAPPING, "services", key) for key in ("mapping_on", "mapping_off")]
        for ability, table, key in named:
            if table == "topics":
                if topic := names.topic(key, robot):
                    or_type = STAMPED_TWIST if ability == DRIVE else ""
                    yield ListenerProbe(key, topic, names.type(key), noun_of(ability), or_type)
            elif service := names.service(key, robot):
                keys = (*services[service].keys, key) if service in services else (key,)
                services[service] = ServiceProbe(keys, service, names.service_type(key), noun_of(ability))
        yield from services.values()

    def stream(self, feed: Feed, msg: object) -> "StreamValue":
        """Return the value of a stream in a message of its topic. Raises WireError."""
        # With numpy, whose import takes longer than a whole command without a screen.
        from fleet_tui.robots.ros.set_up.camera import read_image
        from fleet_tui.robots.ros.set_up.streams import read_path, read_scan

        if feed.key == "tf_static":
            return read_frames(msg)
        if feed.key == CAMERA:
            return read_image(msg)
        return read_scan(msg) if feed.key == SCAN else read_path(msg)

    def outgoing(self, command: commands.SetUp, robot: Robot) -> Sequence[Outgoing]:
        """Return the message or call of a command. Raises CommandError for one that must not be sent."""
        match command:
            case commands.SetPose(_, floor, pose):
                covariance = [0.0] * 36
                covariance[0] = covariance[7] = XY
                covariance[35] = YAW
                placed = {"pose": solid(pose), "covariance": covariance}
                return self._place("initial_pose", robot, floor, placed)
            case commands.SendGoal(_, floor, pose):
                return self._place("goal", robot, floor, solid(pose))
            case commands.CancelGoal(name):
                return self._publish("goal_cancel", name, ALL_GOALS)
            case commands.Localise(name):
                return self._call("localise", name)
            case commands.Settle(name):
                return self._call("settle", name)
            case commands.SetMapping(name, on):
                return self._call("mapping_on" if on else "mapping_off", name)
            case commands.StoreMap(name):
                return self._call(KEYS[command.ability], name, save_request(self._names, command, robot))
            case commands.SendGraph(name) if command.ability in self._keys:
                return self._call(KEYS[command.ability], name, load_request(self._names, command))
            case commands.SendGraph() | commands.StartCharging():
                raise CommandError(robot.kind.lack(command.ability))
            case _:
                assert_never(command)

    def _frame(self, robot: Robot, floor: str) -> str:
        """Return the frame of a floor: a pose in a foreign one is dropped without a word."""
        if chosen := self._names.profile.pose_frame:
            return chosen.replace("{robot}", robot.name).replace("{floor}", floor)
        if self._frames_are_floors:
            return self._site.frames.get(floor, floor)
        return robot.frame_id or "map"

    def _place(self, key: str, robot: Robot, floor: str, pose: Mapping[str, object]) -> tuple[Publication]:
        # Without a stamp: the bridge fills in its own time, ours may be hours off.
        header = {"frame_id": self._frame(robot, floor)}
        return self._publish(key, robot.name, {"header": header, "pose": pose})

    def _publish(self, key: str, robot: str, message: Mapping[str, object]) -> tuple[Publication]:
        names = self._names
        topic = names.topic(key, robot)
        if not topic:
            raise CommandError(Message("{table}.topics.{key} is empty", table=names.table, key=key))
        return (Publication(topic, names.type(key), message),)

    def _call(self, key: str, robot: str, request: Mapping[str, object] | None = None) -> tuple[ServiceCall]:
        names = self._names
        service = names.service(key, robot)
        if not service:
            raise CommandError(Message("{table}.services.{key} is empty", table=names.table, key=key))
        args = names.request(key, {"robot": robot}) if request is None else request
        return (ServiceCall(service, names.service_type(key), args),)
