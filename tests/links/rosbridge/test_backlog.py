"""Backlog of a connection: its age by the bytes that wait, and frames that newer ones replace."""

import asyncio
import socket
from collections.abc import Iterator
from types import SimpleNamespace
from typing import cast

import pytest

from fleet_tui.links.rosbridge.backlog import BEHIND, LONGEST_PIECE, Backlog, Frame
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.ros.reading import FrameReader
from tests.support.polling import HANGS


class Read:
    """A connection of which a test says how far it is read, and the counter of its reader."""

    def __init__(self, descriptor: int) -> None:
        self.bytes_read, self.descriptor = 0, descriptor
        self.factory = SimpleNamespace(fed_at=0.0)
        self.poses = {"/pose": "robot", "/other/pose": "other"}
        topics = {"/pose": "robot", "/battery": "robot"}
        named = {topic: SimpleNamespace(robot=robot) for topic, robot in topics.items()}
        self.counter = SimpleNamespace(overtaken=0, topics=named)

    def progress(self) -> tuple[int, int]:
        return self.bytes_read, self.descriptor


class Line:
    """A socket pair, a backlog on one end, and the frames that it passed on."""

    def __init__(self) -> None:
        self.far, self.near = socket.socketpair()
        self.read = Read(self.near.fileno())
        self.taken: list[bytes] = []
        self.backlog = Backlog(
            cast("Connection", self.read),
            cast("FrameReader", self.read),
            lambda frame: self.taken.append(frame[0]),
        )

    def put(self, topic: str, payload: bytes, at: float = 0.0) -> None:
        frame: Frame = payload, False, at
        self.backlog.put(topic, frame)


@pytest.fixture
def line() -> Iterator[Line]:
    line = Line()
    yield line
    line.far.close()
    line.near.close()


def test_the_oldest_byte_that_is_not_read_gives_the_age(line: Line) -> None:
    assert line.backlog.age(1.0) == 0.0
    line.far.send(b"12345")
    assert line.backlog.age(2.0) == 0.0
    line.far.send(b"678")
    assert line.backlog.age(5.0) == 3.0
    line.near.recv(5)
    line.read.bytes_read = 5
    assert line.backlog.age(6.0) == 1.0, "the first five are read, the others came at 5"
    line.near.recv(3)
    line.read.bytes_read = 8
    assert line.backlog.age(9.0) == 0.0
    line.read.descriptor = -1
    assert line.backlog.age(10.0) == 0.0


async def test_frames_pass_at_once_while_nothing_waits(line: Line) -> None:
    line.put("/battery", b"1")
    line.put("/battery", b"2")
    assert line.taken == [b"1", b"2"] and line.read.counter.overtaken == 0


async def test_of_poses_that_are_read_together_only_the_newest_is_taken(line: Line) -> None:
    for topic, payload in (("/pose", b"1"), ("/other/pose", b"2"), ("/pose", b"3")):
        line.put(topic, payload)
    assert line.taken == []
    await asyncio.sleep(0)
    assert line.taken == [b"3", b"2"] and line.read.counter.overtaken == 1
    line.put("/pose", b"4")
    await asyncio.sleep(0)
    assert line.taken[2:] == [b"4"], "it was not read together with the others"


async def test_a_pose_keeps_its_place_before_another_report_of_its_robot(line: Line) -> None:
    for topic, payload in (("/pose", b"1"), ("/battery", b"2"), ("/pose", b"3"), ("/battery", b"4")):
        line.put(topic, payload)
    await asyncio.sleep(0)
    assert line.taken == [b"1", b"2", b"3", b"4"] and line.read.counter.overtaken == 0


async def test_behind_only_the_newest_of_each_topic_is_taken_the_longest_waiting_first(line: Line) -> None:
    line.far.send(b"1")
    line.backlog.age(1.0)
    line.backlog.age(1.0 + BEHIND)
    for topic, payload in (("/pose", b"1"), ("/battery", b"2"), ("/pose", b"3")):
        line.put(topic, payload, 1.0)
    assert line.taken == []
    assert line.backlog.age(6.0) == 5.0
    async with asyncio.timeout(HANGS):
        while len(line.taken) < 2:  # noqa: ASYNC110  # the loop's next turns take them
            await asyncio.sleep(0)
    assert line.taken == [b"3", b"2"] and line.read.counter.overtaken == 1


async def test_a_batch_that_takes_long_is_gathered_and_dropped_with_the_link(line: Line) -> None:
    line.put("/pose", b"1", at=LONGEST_PIECE)
    assert line.taken == []
    line.backlog.clear()
    line.put("/battery", b"2")
    assert line.taken == [b"2"] and line.backlog.age(9.0) == 0.0
