"""Backlog of one connection: age of the oldest unread frame, and frames dropped in favour of newer ones.

These are poses that were read together with a newer one, and while it is behind frames of every topic."""

import asyncio
import fcntl
import struct
import termios
from collections import deque
from collections.abc import Callable

from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.ros.reading import FrameReader

BEHIND = 0.3
"""Age of the oldest unread byte, in seconds, above which overtaken frames are dropped."""
LONGEST_PIECE = 0.1
"""Seconds that one batch of frames may take: the loop does nothing else meanwhile."""
GATHER = 0.2
"""Seconds for which frames are then gathered, so that newer ones can replace older ones."""
SLICE = 0.02
"""Seconds of decoding after which the connection is read again."""

Frame = tuple[bytes, bool, float]
"""Payload, whether it is binary, and the time it was read (monotonic seconds)."""


class Backlog:
    """Runs on the network loop. `take` receives each frame to be decoded."""

    def __init__(self, connection: Connection, reading: FrameReader, take: Callable[[Frame], None]) -> None:
        self._connection = connection
        self._reading = reading
        self._take = take
        self._arrived: deque[tuple[float, int]] = deque()
        """When how many bytes had arrived in all, read or not."""
        self._newest: dict[str, tuple[float, Frame]] = {}
        """By topic: the time since which a frame waits, and the newest frame. The longest wait is first."""
        self._poses: dict[str, Frame] = {}
        """The newest pose of each robot that was just read."""
        self._timer: asyncio.TimerHandle | None = None
        self._age = 0.0

    def age(self, now: float) -> float:
        """Age of the oldest unread message in seconds, updated with each tick."""
        read, descriptor = self._connection.progress()
        unread = _unread(descriptor)
        while self._arrived and self._arrived[0][1] <= read:
            self._arrived.popleft()
        if unread:
            self._arrived.append((now, read + unread))
        else:  # under TLS a socket holds more bytes than it hands over
            self._arrived.clear()
        self._age = now - self._arrived[0][0] if self._arrived else 0.0
        gathered = next((now - since for since, _ in self._newest.values()), 0.0)
        return max(self._age, gathered)

    def put(self, topic: str, frame: Frame) -> None:
        """Take a frame now or, while the connection is behind, only if no newer one of its topic arrives."""
        if (
            self._age < BEHIND
            and not self._newest
            and frame[2] - self._connection.factory.fed_at < LONGEST_PIECE
        ):
            self._take_newest(topic, frame)
            return
        since, overtaken = self._newest.get(topic, (frame[2], None))
        if overtaken is not None:
            self._reading.counter.overtaken += 1
        self._newest[topic] = since, frame
        if self._timer is None:
            self._timer = asyncio.get_running_loop().call_later(GATHER, self._drain)

    def _take_newest(self, topic: str, frame: Frame) -> None:
        """Take a frame; of a pose not before all that has arrived with it is read, or another report of its
        robot comes: their order stays."""
        robot = self._reading.poses.get(topic)
        if robot is None:
            before = self._poses.pop(self._reading.counter.topics[topic].robot, None)
            if before is not None:
                self._take(before)
            self._take(frame)
            return
        if not self._poses:
            asyncio.get_running_loop().call_soon(self._take_poses)
        if robot in self._poses:
            self._reading.counter.overtaken += 1
        self._poses[robot] = frame

    def _take_poses(self) -> None:
        poses, self._poses = self._poses, {}
        for frame in poses.values():
            self._take(frame)

    def _drain(self) -> None:
        loop = asyncio.get_running_loop()
        until, self._timer = loop.time() + SLICE, None
        while self._newest and loop.time() < until:
            _, frame = self._newest.pop(next(iter(self._newest)))
            self._take(frame)
        if self._newest:
            self._timer = loop.call_later(0, self._drain)

    def clear(self) -> None:
        """Drop all unread frames: the connection is lost."""
        self._arrived.clear()
        self._newest.clear()
        self._poses.clear()
        self._age = 0.0
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None


def _unread(descriptor: int) -> int:
    """Number of unread bytes in the socket, 0 without one."""
    if descriptor < 0:
        return 0
    try:
        return int(struct.unpack("i", fcntl.ioctl(descriptor, termios.FIONREAD, b"\0\0\0\0"))[0])
    except OSError:
        return 0
