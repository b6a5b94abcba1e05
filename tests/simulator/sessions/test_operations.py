"""Operations of clients: what is not listened to, and why."""

import pytest

from fleet_tui.simulator.sessions.operations import Operation, problem_of


@pytest.mark.parametrize(
    ("operation", "ros", "reason"),
    [
        ({}, 1, "Received a message without an op"),
        ({"op": "dance"}, 2, "Unknown operation: dance"),
        ({"op": ["subscribe"]}, 2, "Unknown operation: ['subscribe']"),
        (
            {"op": "send_action_goal", "action": "/a", "action_type": "b"},
            1,
            "Unknown operation: send_action_goal",
        ),
        ({"op": "send_action_goal", "action": "/a", "action_type": "b"}, 2, ""),
        ({"op": "subscribe"}, 1, "Expected a topic field but none was found"),
        ({"op": "subscribe", "topic": None}, 1, "Expected a topic field but none was found"),
        ({"op": "subscribe", "topic": 7}, 1, "Expected field topic to be one of str. Invalid value: 7"),
        (
            {"op": "subscribe", "topic": "/a", "throttle_rate": "1"},
            1,
            "Expected field throttle_rate to be one of int",
        ),
        ({"op": "subscribe", "topic": "/a", "unknown": 7}, 1, ""),
        ({"op": "publish", "topic": "/a", "msg": []}, 1, "Expected field msg to be one of dict"),
    ],
)
def test_an_operation_that_can_not_be_meant_has_its_reason(
    operation: Operation, ros: int, reason: str
) -> None:
    found = problem_of(operation, ros)
    assert found.startswith(reason) and bool(found) is bool(reason)
