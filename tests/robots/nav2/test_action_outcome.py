"""The outcome of a command by the answers of Nav2's action servers."""

import pytest

from fleet_tui.model.commands import CancelOrder, PauseRobot, PlaceOrder, Stage
from fleet_tui.model.order import at_vertices
from tests.support.nav2_adapter import adapter


class TestAnswers:
    @pytest.mark.parametrize(
        ("values", "result", "stage"),
        [
            ({"return_code": 0, "goals_canceling": []}, True, Stage.ACCEPTED),
            ({"return_code": 1}, True, Stage.REFUSED),
            ({"return_code": 2}, True, Stage.REFUSED),
            ({"return_code": 3}, True, Stage.ACCEPTED),
            ({}, True, Stage.UNKNOWN),
            ("Service /x does not exist", False, Stage.REFUSED),
            ("Timeout exceeded while waiting for service response", False, Stage.UNKNOWN),
        ],
    )
    def test_of_a_cancel(self, values: object, result: bool, stage: Stage) -> None:
        assert adapter().outcome(CancelOrder("tb2", "x"), values, result)[0] is stage

    @pytest.mark.parametrize(
        ("values", "result", "stage"),
        [
            ({"return_code": 2}, True, Stage.ACCEPTED),
            ("Service /x does not exist", False, Stage.ACCEPTED),
            ("Timeout exceeded while waiting for service response", False, Stage.UNKNOWN),
        ],
    )
    def test_of_a_pause_of_a_robot_without_goals(self, values: object, result: bool, stage: Stage) -> None:
        assert adapter().outcome(PauseRobot("tb2"), values, result)[0] is stage

    @pytest.mark.parametrize(
        ("values", "status", "stage", "detail"),
        [
            ({}, 4, Stage.DONE, ""),
            ({"missed_waypoints": []}, 4, Stage.DONE, ""),
            ({"missed_waypoints": [1]}, 4, Stage.FAILED, "1 stop missed"),
            (
                {"missed_waypoints": [{"error_code": 0}, {"error_code": 105}], "error_code": 601},
                4,
                Stage.FAILED,
                "no progress (error 105); 2 stops missed",
            ),
            (
                {"missed_waypoints": [{"index": 1}], "error_code": 601},
                4,
                Stage.FAILED,
                "waypoint task failed (error 601); 1 stop missed",
            ),
            ({"error_code": 208, "error_msg": ""}, 6, Stage.FAILED, "no path to the goal (error 208)"),
            ({"error_code": 9001, "error_msg": "x"}, 6, Stage.FAILED, "navigator failed (error 9001): x"),
            ({"error_code": 77}, 6, Stage.FAILED, "error 77"),
            ("broken", 6, Stage.FAILED, ""),
        ],
    )
    def test_of_a_goal(self, values: object, status: int, stage: Stage, detail: str) -> None:
        order = PlaceOrder("tb2", at_vertices("1"))
        assert adapter().outcome(order, values, True, status) == (stage, detail)
