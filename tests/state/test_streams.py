"""Streams beside the state: the newest wins, and only while it is watched."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Reading
from fleet_tui.model.set_up.streams import PlannedPath, Streamed
from fleet_tui.state.streams import APART, TRACK, Streams
from tests.support.fleets import R0, fleet

ROBOT = fleet().robots[R0]


def path(at: float) -> Streamed:
    return Streamed(PlannedPath(np.zeros((1, 2), np.float32), "map", None), at, at)


def test_only_what_is_watched_is_kept() -> None:
    streams = Streams()
    streams.put(R0, "path", path(1.0))
    assert streams.get(R0, "path") is None and not streams.wants(R0, "path")
    streams.watch(R0, "path")
    for at in (2.0, 3.0):
        streams.put(R0, "path", path(at))
    newest = streams.get(R0, "path")
    assert newest is not None and newest.at == 3.0
    streams.unwatch(R0, "path")
    assert streams.get(R0, "path") is None


def test_the_last_of_two_watchers_ends_it() -> None:
    streams = Streams()
    streams.watch(R0, "scan")
    streams.watch(R0, "scan")
    streams.unwatch(R0, "scan")
    assert streams.wants(R0, "scan")
    streams.unwatch(R0, "scan")
    streams.unwatch(R0, "scan")
    assert not streams.wants(R0, "scan")
    streams.watch(R0, "scan")
    assert streams.wants(R0, "scan"), "one too many does not count"


def seen(*poses: tuple[float, float, float]) -> Streams:
    """A robot whose scan is watched: seconds, x and yaw."""
    streams = Streams()
    streams.watch(R0, "scan")
    for at, x, yaw in poses:
        streams.note(replace(ROBOT, pose=Reading(Pose(x, 0.0, yaw), at)))
    return streams


def test_a_pose_between_two_is_on_the_way_and_turns_the_short_way() -> None:
    at = seen((1.0, 0.0, 3.0), (1.2, 2.0, -3.0)).pose_at(R0, 1.1)
    assert at is not None and abs(at.x - 1.0) < 1e-9 and abs(abs(at.yaw) - 3.14159265) < 1e-6


def test_without_a_pose_near_the_place_is_unknown() -> None:
    streams = seen((1.0, 5.0, 0.0))
    assert streams.pose_at(R0, 1.0 + 2 * APART) is None and streams.pose_at("other", 1.0) is None
    near = streams.pose_at(R0, 1.0 + APART / 2)
    assert near is not None and near.x == 5.0
    assert seen((1.0, 0.0, 0.0), (9.0, 8.0, 0.0)).pose_at(R0, 5.0) is None


def test_a_robot_that_is_localised_anew_was_never_at_the_earlier_places() -> None:
    streams = seen((1.0, 0.0, 0.0), (1.1, 0.1, 0.0), (1.1, 7.0, 0.0))
    at = streams.pose_at(R0, 1.05)
    assert at is not None and at.x == 7.0


def test_an_unwatched_robot_leaves_no_track() -> None:
    streams = Streams()
    streams.note(replace(ROBOT, pose=Reading(Pose(1.0, 0.0), 1.0)))
    assert streams.pose_at(R0, 1.0) is None


@given(st.lists(st.floats(0.0, 100.0), max_size=60), st.floats(0.0, 100.0))
def test_any_poses_in_any_order(times: list[float], at: float) -> None:
    streams = seen(*((time, time, 0.0) for time in times))
    found = streams.pose_at(R0, at)
    assert found is None or abs(found.x - at) <= 2 * APART + 1e-6
    assert TRACK > 1
