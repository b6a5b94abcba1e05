"""Messages of robots with move_base as facts."""

import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import Alive, GoalsReported, LocalisationReported, TargetReported
from fleet_tui.model.order import OrderState
from fleet_tui.text.errors import WireError
from tests.support.move_base_adapter import NEVER, OWN, RVIZ, adapter, listed, read, status


class TestHeard:
    """Messages as facts."""

    def test_a_status_lists_the_goals_of_all_and_is_a_sign_of_life(self) -> None:
        facts = read(adapter(), "status", status((OWN, 1, "")))
        assert [type(fact) for fact in facts] == [GoalsReported, Alive]
        ours, other = listed((OWN, 1, "active"), (RVIZ, 0, ""))
        assert (ours.id, ours.uuid, ours.state, ours.word) == (
            "01234567",
            OWN,
            OrderState.IN_PROCESS,
            "active",
        )
        assert (other.uuid, other.state, len(other.id)) == (RVIZ, OrderState.QUEUED, 8)
        assert ours.stamp == 1700000000.0

    def test_an_empty_list_is_news_too(self) -> None:
        assert listed() == ()

    @pytest.mark.parametrize(
        ("number", "text", "state"),
        [
            (2, "", OrderState.CANCELLED),
            (2, "This goal was canceled because another goal was received by the s", OrderState.REPLACED),
            (8, "This goal was canceled because another goal was recieved by the s", OrderState.REPLACED),
            (3, "Goal reached.", OrderState.DONE),
            (4, "Failed to find a valid plan.", OrderState.FAILED),
            (5, "", OrderState.REFUSED),
            (6, "", OrderState.IN_PROCESS),
            (7, "", OrderState.CANCELLED),
            (8, "", OrderState.CANCELLED),
            (9, "", OrderState.LOST),
            (77, "", None),
        ],
    )
    def test_each_state(self, number: int, text: str, state: OrderState | None) -> None:
        (goal,) = listed((OWN, number, text))
        assert (goal.state, goal.said, goal.is_ending) == (state, text, number == 6)

    def test_a_goal_without_an_id_is_left_out_and_said(self) -> None:
        reported = read(adapter(), "status", status(("", 1, ""), (OWN, 1, "")))[0]
        assert isinstance(reported, GoalsReported)
        assert [goal.uuid for goal in reported.goals] == [OWN]
        assert reported.fault == "goal_id.id is empty, which means all goals"
        huge = read(adapter(), "status", status(("x" * 600, 1, "")))[0]
        assert isinstance(huge, GoalsReported) and huge.fault == "goal_id.id has 600 characters"

    def test_ids_of_others_differ_from_one_another(self) -> None:
        found = listed(*[(f"/patrol-{n}-1700000000.5", 1, "") for n in range(50)])
        assert len({goal.id for goal in found}) == 50

    def test_the_target_of_a_goal_that_begins(self) -> None:
        pose = {"position": {"x": 2.0, "y": 3.0, "z": 0.0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}
        message = {"header": {"frame_id": "map", "stamp": NEVER}, "pose": pose}
        assert read(adapter(), "target", message) == [TargetReported("r1", 5.0, Pose(2.0, 3.0))]

    def test_feedback_tells_where_a_robot_is_as_the_last_of_all(self) -> None:
        pose = {"position": {"x": 2.0, "y": 3.0, "z": 0.0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}
        base = {"header": {"frame_id": "map", "stamp": NEVER}, "pose": pose}
        message = {"header": {"frame_id": ""}, "status": {}, "feedback": {"base_position": base}}
        placed = LocalisationReported("r1", 5.0, Pose(2.0, 3.0), "map", None, None, is_feedback=True)
        assert read(adapter(), "feedback", message) == [Alive("r1", 5.0), placed]
        assert "pose" in adapter(topics={"pose": ""}).kind.reports

    def test_what_is_no_message_of_its_type(self) -> None:
        for key in ("status", "target", "feedback"):
            with pytest.raises(WireError):
                read(adapter(), key, {"data": 1})
