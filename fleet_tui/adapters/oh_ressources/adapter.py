"""The adapter of the source's robots."""

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import assert_never

from fleet_tui.adapters.adapter import Call, Feed, Site
from fleet_tui.adapters.answers import judge
from fleet_tui.adapters.oh_ressources.reading import read_graph, read_labels, read_queue
from fleet_tui.adapters.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.ros.facts import (
    Translate,
    read_bool,
    read_map,
    read_metadata,
    read_number,
    read_pose,
)
from fleet_tui.adapters.ros.fields import put
from fleet_tui.adapters.ros.names import Names
from fleet_tui.errors import CommandError
from fleet_tui.model import events, kind
from fleet_tui.model.commands import (
    INT32_MAX,
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    PlaceOrderWithCargo,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.robot import Robot

KEYS = ("pose", "queue", "obstacle", "battery", "cargo", "paused", "graph", "labels", "map_metadata", "map")
"""Topics, the most urgent first."""


class OhRessources:
    """Robots that keep a queue and take orders by service calls."""

    def __init__(self, profile: Profile, site: Site) -> None:
        self.names = names = Names(VOCABULARY, profile, site.table)
        self._site = site
        self._refusals = [re.compile(pattern) for pattern in names.refusals]
        self._readers: dict[str, Translate] = {
            "pose": read_pose(names),
            "queue": read_queue(names),
            "obstacle": read_number(names, "obstacle", events.ObstacleReported, 0.0, math.inf),
            "battery": read_number(names, "battery", events.BatteryReported, 0.0, 101.0),
            "cargo": read_bool(names, "cargo", events.CargoReported),
            "paused": read_bool(names, "paused", events.PausedReported),
            "graph": read_graph(names),
            "labels": read_labels(names),
            "map_metadata": read_metadata(names),
            "map": read_map(names),
        }
        self.kind = kind.Kind(
            "oh_ressources",
            frozenset(key for key in KEYS if names.topic(key, "robot", "floor")),
            frozenset({kind.ORDER, kind.ORDER_TO, kind.CANCEL, kind.CLEAR, kind.PAUSE, kind.RESUME}),
            profile.silence,
        )

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return what to listen to, the most urgent first."""
        for key in KEYS:
            per_floor, is_pose, is_map = key in VOCABULARY.floor_topics, key == "pose", key == "map"
            rate = 0 if per_floor else self._site.pose_ms if is_pose else self._site.status_ms
            for floor in floors if per_floor else [""]:
                topic, type_ = self.names.topic(key, robot, floor), self.names.type(key)
                if topic:
                    yield Feed(key, (robot,), floor, topic, type_, rate, per_floor, is_map, is_map, is_pose)

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[events.Event]:
        """Return the one fact that a message tells. Raises WireError."""
        return (self._readers[feed.key](feed.robot, feed.floor, msg, at),)

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return key, name and type of each service, pauses first."""
        keys = sorted(VOCABULARY.services, key=lambda key: key != "pause")
        return ((key, self.names.service(key, robot), self.names.service_type(key)) for key in keys)

    def outgoing(self, command: Command, command_id: int, robot: Robot) -> Sequence[Call]:
        """Return the call of a command. Raises CommandError for one that must not leave."""
        return (_call(self.names, command, command_id),)

    def outcome(self, command: Command, values: object, result: bool) -> tuple[Stage, str]:
        """Return what an answer means for a command, with the robot's own words."""
        return judge(command, values, result, self._refusals)


def _call(names: Names, command: Command, request_id: int) -> Call:
    """The service call of a command. Raises CommandError for one that must not leave."""
    args: dict[str, object]

    def call(key: str, given: Mapping[str, object]) -> Call:
        return Call(names.service(key, command.robot), names.service_type(key), given)

    match command:
        case PlaceOrder(_, start, end):
            args = {"request_id": request_id, "initial_point": start, "end_point": end}
            return call("order", _named(names, "order_call", args))
        case PlaceOrderWithCargo(robot, end):
            args = {"request_id": request_id, "agent": robot, "end_point": end}
            return call("order_with_cargo", _named(names, "cargo_call", args))
        case CancelOrder(robot, order_id):
            if order_id <= 0:
                raise CommandError(f"order id {order_id} means all orders to the robot: use clear for that")
            args = {"robot": robot, "ind": order_id}
            return call("cancel", _named(names, "cancel_call", args))
        case ClearOrders(robot):
            return call("clear", _named(names, "cancel_call", {"robot": robot, "ind": 0}))
        case PauseRobot():
            return call("pause", {})
        case ResumeRobot():
            return call("resume", {})
        case _:
            assert_never(command)


def _named(names: Names, message: str, args: dict[str, object]) -> dict[str, object]:
    found = dict[str, object]()
    for name, value in args.items():
        if isinstance(value, int) and not -INT32_MAX - 1 <= value <= INT32_MAX:
            raise CommandError(f"{name} {value} does not fit the robot's 32 bits")
        put(found, names.path(message, name), value)
    return found
