"""The simulated laser, against the floor's plan."""

import json
import math

import cbor2
import numpy as np

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.floorplan import RESOLUTION
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.senses.laser import BEAMS, MOUNT, RANGE, ends, ranges, scan, scan_topic
from tests.support.navigating import FLOOR, robot

MIDDLE = Pose(8.0, 0.0, 0.0)


def test_beams_end_at_walls_and_go_through_nothing_before() -> None:
    rows, columns, first = ends(FLOOR.cells, MIDDLE)
    assert rows.shape == columns.shape == (BEAMS, len(rows[0]))
    for beam in range(0, BEAMS, 90):
        walls = np.flatnonzero(FLOOR.cells[rows[beam], columns[beam]] == 100)
        assert first[beam] == (walls[0] if len(walls) else rows.shape[1])


def test_the_wall_behind_the_robot_is_where_the_plan_has_it() -> None:
    found = ranges(FLOOR.cells, Pose(8.0, 0.0, math.pi / 2))
    behind = float(found[0])
    assert abs(behind - 2.3) < 2 * RESOLUTION


def test_what_is_too_far_has_no_range() -> None:
    empty = np.zeros((20, 20), dtype=np.int8)
    assert np.isinf(ranges(empty, Pose(-1.5, -2.5))).all()
    assert ranges(FLOOR.cells, MIDDLE).min() >= 0.1


def test_a_scan_has_nulls_in_json_and_a_typed_array_in_cbor() -> None:
    payload = scan(np.zeros((20, 20), dtype=np.int8), Pose(-1.5, -2.5), {})
    assert json.loads(payload.json)["ranges"] == [None] * BEAMS
    assert cbor2.loads(payload.cbor)["ranges"].tag == 85


def test_every_second_turn_has_a_scan_of_the_true_pose() -> None:
    it = robot()
    it.place(Pose(30.0, 9.0))
    topic = scan_topic(it, ROS1)
    assert topic.due is not None and [topic.due() for _ in range(4)] == [True, False, True, False]
    wanted = scan(FLOOR.cells, it.pose.after(MOUNT), ROS1.header(1, 0.0, "robot_0/laser"))
    assert topic.payload(0.0).json == wanted.json and topic.payload(0.0).msg["range_max"] == RANGE
