"""Set-up commands in words."""

import math

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.commands import Localise, SendGoal, SetMapping, SetPose, heading_text


def test_each_says_what_it_does() -> None:
    pose = Pose(1.0, -2.5, math.pi / 2)
    assert SetPose("r", "hall", pose).text == "set pose (1.00, -2.50) 90°"
    assert SendGoal("r", "hall", pose).text == "go to (1.00, -2.50) 90°"
    assert (Localise("r").text, Localise("r").place) == ("localise", None)
    assert [SetMapping("r", on).text for on in (True, False)] == ["mapping on", "mapping off"]


@given(st.floats(), st.floats(), st.floats())
def test_any_pose_has_a_text(x: float, y: float, yaw: float) -> None:
    assert heading_text(Pose(x, y, yaw)).endswith("°")
