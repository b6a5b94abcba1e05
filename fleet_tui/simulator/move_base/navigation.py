"""The move_base node of one robot: accepts goals and drives the robot. Pure."""

import math
import random
from collections import deque
from itertools import count

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.logs import ERROR, WARN
from fleet_tui.simulator.messages import FRAME, Message, flat, solid
from fleet_tui.simulator.navigating.robot import NO_PROGRESS, TAKEN_OVER, NavigatingRobot
from fleet_tui.simulator.navigating.world import Clock
from fleet_tui.simulator.ros.actionlib import (
    ABORTED,
    PREEMPTED,
    PREEMPTING,
    SUCCEEDED,
    ActionlibGoal,
    GoalReport,
    SimpleActionServer,
)

# metres, radians after which amcl publishes the pose
MOVED = 0.2
TURNED = math.pi / 6
CYCLE = 0.2  # seconds between two attempts of its controller
PATIENCE = 20.0  # seconds for which it tries to plan, recovery behaviours included
NEAR = 0.3  # metres from the charger at which it charges

NO_PLAN = "Failed to find a valid plan. Even after executing recovery behaviors."
NO_CONTROL = "Failed to find a valid control. Even after executing recovery behaviors."
INVALID = "Aborting on goal because it was sent with an invalid quaternion"
REACHED = "Goal reached."


class SimMoveBase:
    """Its attributes are for tests and faults to read and change. `clock`: nanoseconds since 1970."""

    def __init__(self, robot: NavigatingRobot, _ids: random.Random, clock: Clock) -> None:
        self.robot = robot
        self._clock = clock
        robot.moved = MOVED
        robot.turned = TURNED
        self.server = SimpleActionServer(f"/{robot.name}/move_base", clock)
        self.alive = True
        """False: its node is not running."""
        self.publishes = True
        """False: no feedback is sent."""
        self.rejects = False
        """True: every goal is rejected."""
        self.plans = True
        """False: no path exists to any goal."""
        self.received: list[Message] = []
        """Every received goal; the newest last."""
        self.begun: deque[Message] = deque(maxlen=100)
        """The poses of goals that were begun, still to be published."""
        self.forwarded: deque[Message] = deque(maxlen=100)
        """The goals that were made of poses alone, still to be published."""
        self.lines: deque[tuple[int, str]] = deque(maxlen=100)
        """Log lines that are still to be published: level and text."""
        self._sought = 0.0
        self._told_for = 0.0
        self._number = count()
        self._forwarded = count()

    @property
    def busy(self) -> bool:
        return bool(self.server.running)

    def receive_goal(self, message: Message) -> None:
        """Take a move_base_msgs/MoveBaseActionGoal."""
        if self.alive:
            self.received.append(message)
            del self.received[:-1000]
            id_ = message["goal_id"]
            self.server.take(id_["id"], _nanoseconds(id_["stamp"]), message["goal"], self.rejects)

    def receive_pose(self, message: Message) -> None:
        """Take a geometry_msgs/PoseStamped, and forward it as a goal without an id."""
        if self.alive:
            now = _time(self._clock())
            header = {"seq": next(self._forwarded), "stamp": now, "frame_id": ""}
            id_ = {"stamp": _time(0), "id": ""}
            goal = {"header": header, "goal_id": id_, "goal": {"target_pose": message}}
            self.forwarded.append(goal)
            self.receive_goal(goal)

    def receive_cancel(self, message: Message) -> None:
        """Take an actionlib_msgs/GoalID."""
        if self.alive:
            self.robot.left_for = TAKEN_OVER
            self.server.cancel(message["id"], _nanoseconds(message["stamp"]))

    def give(self, x: float, y: float, yaw: float = 0.0) -> None:
        header = {"seq": 0, "stamp": _time(self._clock()), "frame_id": FRAME}
        self.receive_pose({"header": header, "pose": solid(Pose(x, y, yaw))})

    def employ(self, rng: random.Random) -> None:
        floor = self.robot.floor
        spot = floor.graph.vertices[rng.choice(tuple(floor.labels))]
        self.give(spot.x, spot.y, rng.uniform(-3.0, 3.0))

    def recharge(self) -> None:
        charger = self.robot.floor.charger
        self.give(charger.x, charger.y)

    def cancel_all(self) -> None:
        if self.alive:
            self.server.cancel("", 0)

    def abort(self) -> None:
        if self.robot.driving:
            self.robot.fail(*NO_PROGRESS)

    def die(self) -> None:
        """End as a node that crashes."""
        self.restart()
        self.alive = False
        self.server.said.clear()

    def restart(self) -> None:
        """Begin as a node that has just been started."""
        self.robot.halt()
        self.server.restart()

    def step(self, dt: float) -> None:
        self.server.age(dt)
        goal = self.server.accept()
        if goal is not None:
            self._begin(goal)
        elif self.server.current is not None and not self.server.current.over:
            self._advance(self.server.current, dt)

    def _begin(self, goal: ActionlibGoal) -> None:
        assert goal.request is not None
        self.robot.halt()
        self._sought = 0.0
        pose = goal.request["target_pose"]
        if not _is_upright(pose["pose"]["orientation"]):
            self.lines.append((ERROR, "Quaternion is invalid, discarding as a navigation goal"))
            self.server.end(goal, ABORTED, INVALID)
            return
        self._tell_begun(pose)
        if pose["header"]["frame_id"] == FRAME:
            if self.plans:
                self.robot.drive([flat(pose["pose"])])
        else:  # it tries to transform the pose forever, and does not drive
            frame = pose["header"]["frame_id"]
            self.lines.append((WARN, f"Failed to transform the goal pose from {frame} into the map frame"))

    def _tell_begun(self, pose: Message) -> None:
        self._told_for = 0.0
        self.begun.append({**pose, "header": {**pose["header"], "seq": next(self._number)}})

    def _advance(self, goal: ActionlibGoal, dt: float) -> None:
        assert goal.request is not None
        if goal.status == PREEMPTING:
            self._finish(goal, PREEMPTED, "")
        elif self.robot.failure == NO_PROGRESS:
            self._finish(goal, ABORTED, NO_CONTROL)
        elif self.robot.failure is not None or not (self.plans or self.robot.driving):
            self._sought += dt
            if self._sought > PATIENCE:
                self._finish(goal, ABORTED, NO_PLAN)
        elif goal.request["target_pose"]["header"]["frame_id"] != FRAME:
            self._told_for += dt
            if self._told_for > CYCLE:  # each time that it tries again
                self._tell_begun(goal.request["target_pose"])
        elif not self.robot.driving:
            self._finish(goal, SUCCEEDED, REACHED)
            self.robot.docked = self._at_charger()

    def _finish(self, goal: ActionlibGoal, status: int, text: str) -> None:
        self.robot.halt()
        self.server.end(goal, status, text)
        if status == ABORTED:
            self.lines.append((ERROR, text.replace("Failed to find", "Aborting: failed to find")))

    def _at_charger(self) -> bool:
        charger, at = self.robot.floor.charger, self.robot.pose
        return math.dist((charger.x, charger.y), (at.x, at.y)) < NEAR


def _is_upright(turn: Message) -> bool:
    """Tell whether a quaternion is valid and rotates about the vertical axis only."""
    x, y, z, w = (turn[axis] for axis in "xyzw")
    length = x * x + y * y + z * z + w * w
    return math.isfinite(length) and length >= 1e-6 and 2.0 * (x * x + y * y) / length <= 1e-3


def _nanoseconds(time: Message) -> int:
    return int(time["secs"]) * 10**9 + int(time["nsecs"])


def _time(nanoseconds: int) -> Message:
    return {"secs": nanoseconds // 10**9, "nsecs": nanoseconds % 10**9}


def goal_status(status: GoalReport) -> Message:
    """actionlib_msgs/GoalStatus."""
    id_ = {"stamp": _time(status.stamp), "id": status.id}
    return {"goal_id": id_, "status": status.status, "text": status.text}


def statuses(listed: list[GoalReport], header: Message) -> Message:
    """actionlib_msgs/GoalStatusArray."""
    return {"header": header, "status_list": [goal_status(status) for status in listed]}


def result(status: GoalReport, header: Message) -> Message:
    """move_base_msgs/MoveBaseActionResult."""
    return {"header": header, "status": goal_status(status), "result": {}}


def feedback(status: GoalReport, robot: NavigatingRobot, header: Message, at: Message) -> Message:
    """move_base_msgs/MoveBaseActionFeedback; `at` is the header of the robot's pose."""
    position = {"header": at, "pose": solid(robot.belief.of(robot.pose))}
    return {"header": header, "status": goal_status(status), "feedback": {"base_position": position}}
