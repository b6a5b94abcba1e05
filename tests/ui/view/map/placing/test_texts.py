"""The texts of a robot's chip."""

from fleet_tui.model.geometry import Pose
from fleet_tui.ui.view.map.placing.texts import texts_of
from fleet_tui.ui.view.map.scene import SceneRobot
from fleet_tui.ui.view.roles import StyleRole

ARROW = "→", StyleRole.ROBOT


def test_the_first_text_tells_most_and_the_last_is_the_number_alone() -> None:
    robot = SceneRobot("r1", 1, Pose(0.0, 0.0), alarmed=True, said="obstacle (for 40 s)")
    texts = ["".join(text for text, _ in runs) for _, runs in texts_of(robot, ARROW, False, is_large=True)]
    assert texts == ["→1! obstacle (for 40 s)", "obstacle (for 40 s) →1!", "→1!", "→1", "1"]
    small = ["".join(text for text, _ in runs) for _, runs in texts_of(robot, ARROW, False, is_large=False)]
    assert small == texts[2:]
