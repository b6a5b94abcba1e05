"""The adapter of robots with Nav2."""

import math
from collections.abc import Iterable, Sequence
from typing import assert_never

import msgspec

from fleet_tui.adapters.adapter import Call, Feed, Outgoing, Publication, Site
from fleet_tui.adapters.answers import judge
from fleet_tui.adapters.nav2 import reading
from fleet_tui.adapters.nav2.answers import judge_cancel, judge_goal
from fleet_tui.adapters.nav2.goals import cancel_all, cancel_call, cancel_own, order_goal, unknown_goals
from fleet_tui.adapters.nav2.probes import probes
from fleet_tui.adapters.nav2.settings import Settings
from fleet_tui.adapters.nav2.vocabulary import ACTIONS, VOCABULARY
from fleet_tui.adapters.probes import Probe
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.ros.facts import read_map
from fleet_tui.adapters.ros.names import Names
from fleet_tui.model import events, kind, navigation_events
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.robot import Robot

GOALS = ("queue", "progress")
"""Values that come from the actions."""
DRIVES = ("follow_waypoints", "navigate_to_pose")
"""The actions with which orders are given."""
PLAN_MS = 1000
"""Milliseconds between two paths, each of which may be long: only its end counts."""
BATTERY_SILENCE = 60.0
"""Seconds after which a battery's word is old: some drivers publish it every ten seconds."""
STATUS_TYPE = "action_msgs/GoalStatusArray"
FEEDBACK_TYPES = {
    "follow_waypoints": "nav2_msgs/action/FollowWaypoints_FeedbackMessage",
    "navigate_to_pose": "nav2_msgs/action/NavigateToPose_FeedbackMessage",
}


class Nav2:
    """Robots that drive one goal at a time, and give each goal's state to all clients."""

    def __init__(self, profile: Profile, site: Site) -> None:
        self.names = names = Names(VOCABULARY, profile, site.table)
        self._site = site
        self._settings = msgspec.convert(profile.settings.get("nav2", {}), Settings)
        self._read_map = read_map(names)
        self._readers: dict[str, reading.Read] = {
            "odometry": reading.read_odometry(names),
            "pose": reading.read_localisation(names),
            "battery": reading.read_battery(names),
            "blocked": reading.read_blocked(names),
            "floor": reading.read_floor(names),
            "plan": reading.read_plan(names),
            **{action: reading.read_goals(action) for action in ACTIONS},
            **{f"{action} feedback": reading.read_feedback() for action in FEEDBACK_TYPES},
        }
        self.kind = kind.Kind(
            "nav2",
            (*(key for key in ("odometry", "pose", "battery", "blocked", "map") if self._has(key)), *GOALS),
            (kind.ORDER, kind.ORDER_TO, kind.CANCEL, kind.CLEAR, *self._pauses),
            {**self._silence(), **profile.silence},
            self._unset,
            frames_are_floors=False,
            tells_ends=True,
            keeps_goals=True,
            holds=self._holds,
            changes_floors=False,
        )

    def _silence(self) -> dict[str, float]:
        usual = {"battery": BATTERY_SILENCE, "queue": math.inf, "blocked": math.inf}
        # The localisation of a robot that stands is silent: only wheels tell that it is still there.
        return usual if self._has("odometry") else {**usual, "pose": math.inf}

    def _has(self, key: str) -> bool:
        return bool(self.names.topic(key, "robot", "floor"))

    @property
    def _pauses(self) -> tuple[str, ...]:
        """What stands in for a pause, if anything does."""
        return (kind.PAUSE, kind.RESUME) if self._holds or self._has_switch else ()

    @property
    def _unset(self) -> dict[str, str]:
        """The key that lacks for a pause over a lock."""
        if self._settings.pause != "lock" or self._has_switch:
            return {}
        return dict.fromkeys((kind.PAUSE, kind.RESUME), f"{self.names.table}.topics.pause_navigation")

    @property
    def _has_switch(self) -> bool:
        locks = self._settings.pause == "lock" and self._has("pause_navigation")
        return locks or self._has_services

    @property
    def _has_services(self) -> bool:
        """One alone is none: what it paused nothing would resume."""
        return all(self.names.service(key, "robot") for key in ("pause", "resume"))

    @property
    def _holds(self) -> bool:
        return self._settings.pause == "hold" and not self._has_switch

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return what to listen to, the most urgent first. A bridge subscribes one by one: the goals come
        before the first sign of life, so that an order to a robot that is heard replaces nobody's."""
        site, latched = self._site, Feed("", (robot,), "", "", "", latched=True, silent=True)
        yield from self._statuses(robot, DRIVES)
        yield from self._feed("odometry", robot, Feed("", (robot,), "", "", "", site.pose_ms, fast=True))
        yield from self._feed("pose", robot, latched)
        yield from self._feedback(robot)
        slow = Feed("", (robot,), "", "", "", site.status_ms)
        yield from self._feed("battery", robot, slow)
        yield from self._statuses(robot, [action for action in ACTIONS if action not in DRIVES])
        yield from self._feed("blocked", robot, slow._replace(rate_ms=0, silent=True))
        yield from self._feed("floor", robot, latched)
        yield from self._feed("plan", robot, slow._replace(rate_ms=PLAN_MS, silent=True, on_demand=True))
        topic = self.names.profile.topics.get("map", VOCABULARY.topics["map"][0])
        of_map = latched._replace(silent=False, on_demand=True, large=True, is_shared="{robot}" not in topic)
        for floor in floors:
            yield from self._feed("map", robot, of_map._replace(floor=floor))

    def _statuses(self, robot: str, actions: Iterable[str]) -> Iterable[Feed]:
        for action in actions:
            if name := self.names.action(action, robot):
                status = f"{name}/_action/status"
                yield Feed(action, (robot,), "", status, STATUS_TYPE, latched=True, silent=True)

    def _feedback(self, robot: str) -> Iterable[Feed]:
        for action, type_ in FEEDBACK_TYPES.items():
            if name := self.names.action(action, robot):
                address, key = f"{name}/_action/feedback", f"{action} feedback"
                yield Feed(key, (robot,), "", address, type_, self._site.status_ms, silent=True)

    def _feed(self, key: str, robot: str, like: Feed) -> Iterable[Feed]:
        if topic := self.names.topic(key, robot, like.floor):
            yield like._replace(key=key, address=topic, type=self.names.type(key))

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[events.Event]:
        """Return the facts that a message tells. Raises WireError."""
        if feed.key == "map":
            return (self._read_map(feed.robot, feed.floor, msg, at),)
        return self._readers[feed.key](feed.robot, msg, at)

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return key, name and type of each service, pauses first. Those of actions are in no list."""
        for key in ("pause", "resume"):
            if name := self.names.service(key, robot):
                yield key, name, self.names.service_type(key)

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return what decides whether such a robot can be driven."""
        return probes(self.names, robot)

    def outgoing(self, command: Command, command_id: int, robot: Robot) -> Sequence[Outgoing]:
        """Return what carries a command, in the order in which it must leave. Raises CommandError for one
        that must not; nothing for one that this console carries out itself."""
        match command:
            case PlaceOrder(_, stops):
                return (order_goal(self.names, robot, stops),)
            case CancelOrder(_, order_id):
                return (cancel_call(self.names, robot, order_id),)
            case ClearOrders():
                return cancel_own(self.names, robot)
            case PauseRobot():
                return self._switch("pause", robot, True) or cancel_all(self.names, robot)
            case ResumeRobot():
                return self._switch("resume", robot, False)
            case _:
                assert_never(command)

    def _switch(self, key: str, robot: Robot, locked: bool) -> Sequence[Outgoing]:
        """Return what pauses a robot that has a switch for it."""
        if self._has_services:
            return (Call(self.names.service(key, robot.name), self.names.service_type(key), {}),)
        topic = self.names.topic("pause_navigation", robot.name)
        if self._settings.pause == "lock" and topic:
            return (Publication(topic, self.names.type("pause_navigation"), {"data": locked}),)
        return ()

    def outcome(
        self, command: Command, values: object, result: bool, status: int | None = None
    ) -> tuple[Stage, str]:
        """Return what an answer means for a command; `status` is that of a goal."""
        if status is not None:
            return judge_goal(values, status, result)
        if isinstance(values, dict) and "success" in values:
            return judge(command, values, result, ())
        return judge_cancel(command, values, result)

    def learned(
        self, call: Call, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[events.Event]:
        """Return which goals an action server does not know: it tells that no other way once it was started
        anew."""
        if gone := unknown_goals(self.names, call, values, robot, sent_at):
            yield navigation_events.GoalsUnknown(robot.name, at, gone)


ADAPTER = Nav2
