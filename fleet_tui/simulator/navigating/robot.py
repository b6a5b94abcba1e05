"""One simulated robot that drives to poses, with errors in odometry and localisation. Pure."""

import math
import random
from collections.abc import Sequence

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.navigating.paths import NoPathError, Spot, length, plan
from fleet_tui.simulator.robot import CHARGE, DRAIN, DRAIN_STANDING, SPEED, STEP, TURN, RobotBody, Work
from fleet_tui.simulator.warehouse import SimFloor

# odometry measured per metre and per radian
SLIP = 1.01
SKID = 1.004
# variance of x and of y in square metres
SURE = 0.0025
LOST = 4.0
PROGRESS = 10.0  # seconds without progress before it tries a recovery
TAKEN_OVER = 120.0  # seconds for which the other client leaves a robot to somebody who cancelled its goal
RECOVERIES = 3  # recoveries before it aborts
NO_PROGRESS = 105, "Failed to make progress"

Failure = tuple[int, str]
"""Nav2's error code and text."""


class NavigatingRobot(RobotBody):
    """A robot without a queue."""

    percent = 0.01
    """The factor of the percentage: 0.01 = it is 0 to 1, 1 = 0 to 100, NaN = it is not measured."""
    odometry = True
    """False: its wheels are not counted."""
    variance = SURE
    """Variance that its localisation reports, in square metres."""
    moved, turned = 0.25, 0.2
    """Metres and radians after which its localisation publishes the pose."""
    docked = False
    is_unlocalised = False
    """True: the node of its localisation has died."""
    localised_last: tuple[Pose, float] | None = None
    """The pose and the Unix second of its death: what its navigation goes on believing."""
    is_lost_at_start = False
    """True: its localisation has no pose until one is set."""
    left_for = 0.0
    """Seconds for which the other client sends it no goals, since somebody else cancelled one."""
    speed = 0.0, 0.0
    """Metres and radians per second in the last step."""

    def __init__(self, index: int, floor: SimFloor, pose: Pose, rng: random.Random, quiet: bool) -> None:
        super().__init__(index, pose, rng, quiet)
        self.floor = floor
        self.odom = Pose(0.0, 0.0)
        """The pose by odometry, relative to its start."""
        self.estimate = pose
        """The last pose on the map published by its localisation."""
        self.driving = self.moving = False
        """True while it drives; true if it progressed in the last step."""
        self.way: list[Spot] = []
        """The corners still before it."""
        self.turns_left = 0.0
        """Radians to turn on the spot without a drive."""
        self.stops = 0
        """The remaining poses."""
        self.recoveries = 0
        self.failure: Failure | None = None
        """The reason that its last drive was aborted."""
        self._stood = 0.0
        self._work: Work = iter(())
        self._was_placed = False

    @property
    def distance_remaining(self) -> float:
        """Metres to its goal, 0 before it has a plan."""
        return length([(self.pose.x, self.pose.y), *self.way]) if self.way else 0.0

    @property
    def time_remaining(self) -> float:
        """Return the seconds to its goal, 0 without one."""
        return self.distance_remaining / SPEED if self.moving else 0.0

    def drive(self, poses: Sequence[Pose]) -> None:
        """Drive to these poses one after the other, from now on."""
        self.halt()
        self.driving = True
        self.docked = False
        self._work = self._drive(poses)

    def halt(self) -> None:
        self.driving = self.moving = False
        self.way = []
        self.stops = 0
        self.recoveries = 0
        self.failure = None
        self._stood = 0.0
        self._work = iter(())

    def fail(self, code: int, message: str) -> None:
        self.halt()
        self.failure = code, message

    def lose(self) -> None:
        """Make its localisation unsure, and wrong by as much."""
        self.variance = LOST

    def place(self, pose: Pose) -> None:
        """Take its pose from outside, and publish it."""
        self.belief.place(pose, self.pose)
        self.variance = SURE
        self._was_placed = True
        self.is_lost_at_start = False

    def step(self) -> None:
        self.silence, self.left_for = (max(0.0, one - STEP) for one in (self.silence, self.left_for))
        before = self.pose
        if self.driving:
            held = self._blocked(self.moving and not self._quiet) or self.stuck
            if not held:
                next(self._work, None)
        else:
            if self.obstacle:
                self._blocked(self.moving and not self._quiet)
            if not self.stuck:
                self.pose = self.wheels.carry(self.pose, STEP)
                self._spin()
        self.moving = self.driving and self.pose != before
        self._watch_progress()
        self._count_wheels(before)
        self.belief.carry(before, self.pose)
        self._charge_by(CHARGE if self.docked else -DRAIN if self.moving else -DRAIN_STANDING)

    def localise(self) -> bool:
        """Tell whether the localisation publishes a pose: only once the robot has moved far enough."""
        if self.is_unlocalised or self.is_lost_at_start:
            return False
        at, last = self.belief.of(self.pose), self.estimate
        off = math.sqrt(self.variance) if self.variance >= LOST else 0.0
        turned = abs(math.remainder(at.yaw - last.yaw, math.tau))
        metres = math.dist((at.x + off, at.y), (last.x, last.y))
        if turned < self.turned and metres < self.moved and not self._was_placed:
            return False
        self._was_placed = False
        self.estimate = Pose(at.x + off, at.y, at.yaw)
        return True

    def _drive(self, poses: Sequence[Pose]) -> Work:
        self.stops = len(poses)
        yield
        for pose in poses:
            try:
                self.way = plan(self.floor, self.pose, pose)[1:]
            except NoPathError as error:
                self.fail(error.code, str(error))
                return
            while self.way:
                yield from self._reach(*self.way[0])
                self.way = self.way[1:]
            yield from self._face(pose.yaw)
            self.stops -= 1
        self.driving = False

    def _spin(self) -> None:
        turned = min(self.turns_left, TURN * STEP)
        self.turns_left -= turned
        self.pose = Pose(self.pose.x, self.pose.y, math.remainder(self.pose.yaw + turned, math.tau))

    def _watch_progress(self) -> None:
        self._stood = 0.0 if self.moving or not self.driving else self._stood + STEP
        if self._stood > PROGRESS:
            self._stood = 0.0
            self.recoveries += 1
            if self.recoveries > RECOVERIES:
                self.fail(*NO_PROGRESS)

    def _count_wheels(self, before: Pose) -> None:
        dx, dy = self.pose.x - before.x, self.pose.y - before.y
        turned = math.remainder(self.pose.yaw - before.yaw, math.tau)
        self.speed = math.hypot(dx, dy) / STEP, turned / STEP
        if self.pose == before:
            return
        turn = self.odom.yaw - before.yaw
        x = self.odom.x + SLIP * (dx * math.cos(turn) - dy * math.sin(turn))
        y = self.odom.y + SLIP * (dx * math.sin(turn) + dy * math.cos(turn))
        self.odom = Pose(x, y, math.remainder(self.odom.yaw + SKID * turned, math.tau))
