"""Laser scans and paths from the wire: of a real bridge, and hostile ones."""

import json
import math
from typing import Any

import cbor2
import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.set_up.streams import beams_of
from fleet_tui.robots.ros.operations import Publish, decode
from fleet_tui.robots.ros.set_up.streams import MOST_BEAMS, MOST_POSES, read_path, read_scan
from fleet_tui.text.errors import WireError
from tests.support.fleets import recording


def scan(**values: Any) -> dict[str, Any]:
    usual = {"angle_min": -1.0, "angle_increment": 0.5, "range_min": 0.1, "range_max": 9.0, "ranges": [1.0]}
    return {"header": {"frame_id": "/laser", "stamp": {"secs": 7, "nsecs": 0}}} | usual | values


def raw(value: object) -> msgspec.Raw:
    return msgspec.Raw(json.dumps(value).encode())


@pytest.mark.parametrize("name", ["rosapi-and-scan.jsonl", "ros2-topics.jsonl.gz"])
def test_scans_of_a_real_bridge_are_read(name: str) -> None:
    count = 0
    for one in recording(name):
        operation = decode(one["text"].encode()) if one["dir"] == "in" and "text" in one else None
        if isinstance(operation, Publish) and operation.topic.endswith("/scan"):
            found = read_scan(operation.msg)
            beams = beams_of(found, None)
            assert found.stamp and found.frame_id and 0 < len(beams.points) <= beams.sent
            count += 1
    assert count


def test_json_and_cbor_say_the_same() -> None:
    values = [1.0, 2.5, math.inf, math.nan, 9.5]
    text = read_scan(raw(scan(ranges=[1.0, 2.5, None, None, 9.5])))
    for tag, dtype in ((85, "<f4"), (86, "<f8"), (81, ">f4")):
        array = cbor2.CBORTag(tag, np.array(values, dtype).tobytes())
        binary = read_scan(scan(ranges=array))
        assert np.array_equal(beams_of(text, None).points, beams_of(binary, None).points)
    assert (text.frame_id, text.stamp, len(text.ranges)) == ("laser", 7.0, 5)


def test_limits_that_are_no_numbers_limit_nothing() -> None:
    found = read_scan(raw(scan(range_min=None, range_max=None, ranges=[5.0, -1.0, 0.0])))
    assert len(beams_of(found, None).points) == 1
    nan = read_scan(scan(range_min=math.nan, range_max=math.nan, ranges=[5.0]))
    assert len(beams_of(nan, None).points) == 1


@pytest.mark.parametrize(
    "wrong",
    [
        {"ranges": "x"},
        {"ranges": ["x"]},
        {"ranges": cbor2.CBORTag(85, b"abc")},
        {"ranges": cbor2.CBORTag(72, b"abcd")},
        {"ranges": [1.0] * (MOST_BEAMS + 1)},
        {"ranges": cbor2.CBORTag(85, bytes(4 * (MOST_BEAMS + 1)))},
        {"angle_min": math.nan},
        {"angle_increment": math.inf},
        {"angle_increment": 1e300},
    ],
)
def test_what_is_no_scan_is_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(WireError):
        read_scan(scan(**wrong))


JSON = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False, allow_infinity=False) | st.text(max_size=3),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=3), inner, max_size=3),
    max_leaves=8,
)


@given(st.dictionaries(st.sampled_from(["ranges", "angle_min", "range_min", "header", "poses"]), JSON))
def test_anything_is_read_or_refused(message: dict[str, Any]) -> None:
    for read, whole in ((read_scan, scan(**message)), (read_path, {"poses": [], **message})):
        for form in (raw(whole), whole):
            try:
                read(form)
            except WireError:
                continue


def path(*points: tuple[float, float]) -> dict[str, Any]:
    turn = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
    poses = [{"pose": {"position": {"x": x, "y": y, "z": 0.0}, "orientation": turn}} for x, y in points]
    return {"header": {"frame_id": "map"}, "poses": poses}


def test_a_path_has_one_point_for_each_cell_and_its_end() -> None:
    found = read_path(raw(path(*((n * 0.01, 0.0) for n in range(101)))))
    assert 20 <= len(found.points) <= 22 and tuple(found.points[-1]) == (1.0, 0.0)
    assert found.frame_id == "map" and len(read_path(path()).points) == 0


@pytest.mark.parametrize("points", [[(math.nan, 0.0)], [(1e300, 0.0)], [(0.0, 0.0)] * (MOST_POSES + 1)])
def test_what_is_no_path_is_refused(points: list[tuple[float, float]]) -> None:
    with pytest.raises(WireError):
        read_path(path(*points))
