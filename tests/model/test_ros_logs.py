"""Severities of either ROS are one."""

import pytest

from fleet_tui.model.ros_logs import LogLine, Severity


@pytest.mark.parametrize("levels", [(1, 2, 4, 8, 16), (10, 20, 30, 40, 50)])
def test_levels_of_both_generations(levels: tuple[int, ...]) -> None:
    assert [LogLine(0.0, level, "n", "t").severity for level in levels] == list(Severity)


def test_a_number_that_nobody_knows_has_none() -> None:
    assert LogLine(0.0, 7, "n", "t").severity is None
