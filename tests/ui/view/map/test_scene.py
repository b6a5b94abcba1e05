"""The scene: the one robot that is selected."""

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.scene import Scene, SceneRobot


def test_the_selected_robot_is_the_one_on_this_floor_or_none() -> None:
    here, there = (SceneRobot(f"robot_{n}", n + 1, Pose(0.0, 0.0), selected=n == 1) for n in range(2))
    frame = MapFrame(1.0, 2, 2)
    assert Scene("f", frame, robots=(here, there)).selected is there
    assert Scene("f", frame, robots=(here,)).selected is None and Scene("f", frame).selected is None
