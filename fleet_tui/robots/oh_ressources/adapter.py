"""The adapter of the source's robots."""

import math
import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Literal

from fleet_tui.model import events, kind
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SendGraph, SetUpCommand, StoreMap
from fleet_tui.robots.adapter import Feed, Outgoing, ServiceCall, Site
from fleet_tui.robots.oh_ressources.calls import call_of
from fleet_tui.robots.oh_ressources.graphs import graph_messages, unset_key
from fleet_tui.robots.oh_ressources.reading import read_graph, read_labels, read_queue
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.robots.probes import Probe
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.facts import Translate, read_bool, read_map, read_metadata, read_number, read_pose
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros.set_up.reading import read_mode
from fleet_tui.robots.ros.set_up.requests import SetUpRequests
from fleet_tui.robots.ros.set_up.saving import judge_saved
from fleet_tui.robots.service_outcome import judge
from fleet_tui.text.language import Message

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import StreamValue

KEYS = ("pose", "queue", "obstacle", "battery", "cargo", "paused", "graph", "labels", "map_metadata", "map")
"""Topics, the most urgent first."""
ABILITIES = {
    "order": kind.ORDER,
    "order_with_cargo": kind.ORDER_TO,
    "cancel": kind.CANCEL,
    "clear": kind.CLEAR,
    "pause": kind.PAUSE,
    "resume": kind.RESUME,
}
"""The use of each service."""


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
            "mode": read_mode(names),
        }
        self._set_up = SetUpRequests(names, site, frames_are_floors=True)
        self.kind = self._kind()

    def _kind(self) -> kind.Kind:
        names, set_up = self.names, self._set_up
        missing = [key for key in ABILITIES if not names.service(key, "robot")]
        no_graph = unset_key(names)
        unset = {ABILITIES[key]: f"{names.table}.services.{key}" for key in missing} | set_up.unset
        return kind.Kind(
            "oh_ressources",
            tuple(key for key in (*KEYS, "mode") if names.topic(key, "robot", "floor")),
            (
                *(asked for key, asked in ABILITIES.items() if key not in missing),
                *set_up.accepted,
                *(() if no_graph else (kind.GRAPH,)),
            ),
            {"mode": math.inf, **names.profile.silence},
            {**unset, kind.GRAPH: no_graph} if no_graph else unset,
            streams=set_up.streams,
            pose_topic=names.topic("pose", "{robot}"),
        )

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return the topics to subscribe to, the most urgent first."""
        for key in KEYS:
            per_floor, is_pose, is_map = key in VOCABULARY.floor_topics, key == "pose", key == "map"
            rate = 0 if per_floor else self._site.pose_ms if is_pose else self._site.status_ms
            for floor in floors if per_floor else [""]:
                topic, type_ = self.names.topic(key, robot, floor), self.names.type(key)
                if topic:
                    wanted: Literal["", "map"] = "map" if is_map else ""
                    yield Feed(key, (robot,), floor, topic, type_, rate, per_floor, wanted, is_map, is_pose)
        yield from self._set_up.feeds(robot)

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[events.Event]:
        """Return the one event of a message, none of a stream. Raises WireError."""
        if feed.wanted_for == "stream":
            return ()
        return (self._readers[feed.key](feed.robot, feed.floor, msg, at),)

    def stream(self, feed: Feed, msg: object) -> "StreamValue":
        """Return the value of a stream. Raises WireError."""
        return self._set_up.stream(feed, msg)

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return key, name and type of each service, pauses first."""
        keys = sorted(ABILITIES, key=lambda key: key != "pause")
        named = ((key, self.names.service(key, robot), self.names.service_type(key)) for key in keys)
        return (service for service in named if service[1])

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return nothing: commands are calls."""
        return ()

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return the checks of set-up: other topics and services suffice."""
        return self._set_up.probes(robot)

    def outgoing(
        self, command: Command, command_id: int, robot: Robot, unique: str = ""
    ) -> Sequence[Outgoing]:
        """Return the call or message of a command. Raises CommandError for one that must not be sent."""
        if isinstance(command, SendGraph):
            return graph_messages(self.names, command)
        if isinstance(command, SetUpCommand):
            return self._set_up.outgoing(command, robot)
        return (call_of(self.names, command, command_id),)

    def outcome(
        self, command: Command, values: object, result: bool, status: int | None = None
    ) -> tuple[Stage, Message]:
        """Return the stage of a command that an answer leads to, with the robot's own text."""
        if isinstance(command, StoreMap) and result and (end := judge_saved(self.names, command, values)):
            return end
        return judge(command, values, result, self._refusals)

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[events.Event]:
        """Return nothing: topics report everything."""
        return ()


ADAPTER = OhRessources
