"""Tests of config/entries."""

import pytest

from fleet_tui.config.entries import FloorEntry


@pytest.mark.parametrize(("frame_id", "frame"), [("", "hall"), ("map_1", "map_1"), ("/map_1", "map_1")])
def test_poses_of_a_floor_are_in_its_frame_else_in_one_of_its_name(frame_id: str, frame: str) -> None:
    assert FloorEntry("hall", frame_id=frame_id).frame == frame
