"""An action server of ROS 2: who is meant by a cancel, and what is listed."""

import pytest

from fleet_tui.simulator.ros.goals import (
    CANCELING,
    EXECUTING,
    KEPT,
    LISTED,
    OK,
    REJECTED,
    SUCCEEDED,
    TERMINATED,
    UNKNOWN,
    ActionServer,
    ServedGoal,
)

NO_ROBOTS = bytes(16)


class TestCancelGoal:
    """The rules of ROS 2: by id, up to a stamp, or all."""

    def server(self) -> tuple[ActionServer, list[ServedGoal]]:
        server = ActionServer("/r/a", "p/T", lambda _: True, lambda _: None)
        goals = [server.take(bytes([n] * 16), n * 10, {}) for n in (1, 2, 3)]
        return server, [goal for goal in goals if goal is not None]

    @pytest.mark.parametrize(
        ("id_", "stamp", "meant"),
        [
            (NO_ROBOTS, 0, [1, 2, 3]),
            (NO_ROBOTS, 20, [1, 2]),
            (NO_ROBOTS, 5, []),
            (bytes([2] * 16), 0, [2]),
            (bytes([3] * 16), 10, [1, 3]),
            (bytes([9] * 16), 10, [1]),
        ],
    )
    def test_who_is_meant(self, id_: bytes, stamp: int, meant: list[int]) -> None:
        server, goals = self.server()
        answer = server.cancel(id_, stamp)
        assert answer["return_code"] == OK
        assert [goal.id[0] for goal in answer["goals_canceling"]] == meant
        assert [goal.id[0] for goal in goals if goal.status == CANCELING] == meant

    def test_one_that_is_not_there_or_over_is_refused_with_its_code(self) -> None:
        server, goals = self.server()
        assert server.cancel(bytes([9] * 16), 0)["return_code"] == UNKNOWN
        server.advance(goals[0], SUCCEEDED)
        assert server.cancel(goals[0].id, 0)["return_code"] == TERMINATED
        server.refuses_cancel = True
        assert server.cancel(goals[1].id, 0) == {"return_code": REJECTED, "goals_canceling": []}
        assert goals[1].status == EXECUTING

    def test_ended_goals_are_listed_for_a_while_and_never_too_many(self) -> None:
        server, goals = self.server()
        for goal in goals:
            server.advance(goal, SUCCEEDED)
        server.age(KEPT - 0.1)
        assert len(server.goals) == 3
        server.age(0.2)
        assert not server.goals
        for n in range(3 * LISTED):
            taken = server.take(n.to_bytes(16, "big"), n, {})
            assert taken is not None
            server.advance(taken, SUCCEEDED)
        assert len(server.goals) <= LISTED + 1 and len(server.reports) <= LISTED
