"""The adapter of robots with Nav2."""

import math
from collections.abc import Iterable, Sequence

from fleet_tui.model import commands, events, navigation_events
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SendGraph, SetUpCommand, StoreMap
from fleet_tui.robots.adapter import Feed, ServiceCall, Site
from fleet_tui.robots.nav2 import reading
from fleet_tui.robots.nav2.action_outcome import judge_cancel, judge_goal
from fleet_tui.robots.nav2.goals import cancel, cancel_all, cancel_own, order, stopped_motion, unknown_goals
from fleet_tui.robots.nav2.probes import probes
from fleet_tui.robots.nav2.settings import Nav2Settings
from fleet_tui.robots.nav2.vocabulary import ACTIONS, VOCABULARY
from fleet_tui.robots.probes import Probe
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.set_up.saving import judge_saved
from fleet_tui.robots.ros_navigation import feeds
from fleet_tui.robots.ros_navigation.base import GoalMessages, NavigationAdapter
from fleet_tui.robots.ros_navigation.kinds import kind_of_goals
from fleet_tui.robots.service_outcome import judge
from fleet_tui.text.language import Message

REPORTS = ("blocked", "map", "queue", "progress")
"""Values besides position and charge; the last two are from the actions."""
SERVERS_SILENCE = 30.0
"""Seconds after which the state of the servers is old: all robots of a link are asked one after the other."""
DRIVES = ("follow_waypoints", "navigate_to_pose")
"""The actions with which orders are given."""
STATUS_TYPE = "action_msgs/GoalStatusArray"
FEEDBACK_TYPES = {
    "follow_waypoints": "nav2_msgs/action/FollowWaypoints_FeedbackMessage",
    "navigate_to_pose": "nav2_msgs/action/NavigateToPose_FeedbackMessage",
}

GOALS = GoalMessages(order, cancel, cancel_own, cancel_all)


class Nav2(NavigationAdapter):
    """Robots that drive one goal at a time, and report each goal's state to all clients."""

    def __init__(self, profile: Profile, site: Site) -> None:
        super().__init__("nav2", VOCABULARY, profile, site, Nav2Settings, GOALS)
        self.readers = {
            **self.readers,
            "blocked": reading.read_blocked(self.names),
            **{action: reading.read_goals(action) for action in ACTIONS},
            **{f"{action} feedback": reading.read_feedback() for action in FEEDBACK_TYPES},
        }
        silence = {"queue": math.inf, "blocked": math.inf, "servers": SERVERS_SILENCE}
        reports = (*REPORTS, "servers") if self.names.service("is_active", "robot") else REPORTS
        self.kind = kind_of_goals("nav2", self.names, self.pauses, self.set_up, reports, silence)

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return the topics to subscribe to, the most urgent first. A bridge subscribes one by one: goals
        precede the first sign of life, so that an order to a robot that is online replaces no other
        client's."""
        names, site = self.names, self.site
        yield from self._statuses(robot, DRIVES)
        yield from feeds.places(names, site, robot)
        yield from self._feedback(robot)
        yield from feeds.battery(names, site, robot)
        yield from self._statuses(robot, [action for action in ACTIONS if action not in DRIVES])
        yield from feeds.feed(names, robot, Feed("", (robot,), "", "", "", silent=True), "blocked")
        yield from feeds.surroundings(names, robot, floors)
        yield from self.set_up.feeds(robot)

    def _statuses(self, robot: str, actions: Iterable[str]) -> Iterable[Feed]:
        for action in actions:
            if name := self.names.action(action, robot):
                status = f"{name}/_action/status"
                yield Feed(action, (robot,), "", status, STATUS_TYPE, latched=True, silent=True)

    def _feedback(self, robot: str) -> Iterable[Feed]:
        for action, type_ in FEEDBACK_TYPES.items():
            if name := self.names.action(action, robot):
                address, key = f"{name}/_action/feedback", f"{action} feedback"
                rate = self.site.status_ms
                yield Feed(key, (robot,), "", address, type_, rate, silent=True, action=action)

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return the checks of whether such a robot can be driven."""
        yield from probes(self.names, robot)
        yield from self.set_up.probes(robot)

    def outcome(
        self, command: commands.Command, values: object, result: bool, status: int | None = None
    ) -> tuple[commands.Stage, Message]:
        """Return the stage of a command that an answer leads to; `status` is that of a goal."""
        if status is not None:
            return judge_goal(values, status, result)
        if (
            result
            and isinstance(command, StoreMap | SendGraph)
            and (end := judge_saved(self.names, command, values))
        ):
            return end
        if isinstance(command, SetUpCommand) or (isinstance(values, dict) and "success" in values):
            return judge(command, values, result, ())
        return judge_cancel(command, values, result)

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[events.Event]:
        """Return the goals unknown to an action server: the only sign that it was restarted; and what a pause
        ended that is in no list of goals."""
        if gone := unknown_goals(self.names, call, values, robot, sent_at):
            yield navigation_events.GoalsUnknown(robot.name, at, gone)
        if motion := stopped_motion(call, values, robot, sent_at):
            yield navigation_events.MotionStopped(robot.name, at, motion)


ADAPTER = Nav2
