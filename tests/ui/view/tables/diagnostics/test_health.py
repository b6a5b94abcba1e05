"""Diagnostics of the robots, the worst first, the values of a row where it is opened."""

from fleet_tui.model.ros_logs import PartDiagnosis
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.diagnostics.health import health_table
from tests.support.diagnostics import NOW, counter, seen, text
from tests.support.fleets import LINK, T0


def test_health_with_the_worst_first_and_values_where_a_row_is_opened() -> None:
    link = counter()
    link.take_health(
        [
            PartDiagnosis(NOW, "robot_1: laser", 1, "something is close", "l1", (("distance", "0.2"),)),
            PartDiagnosis(NOW, "robot_10: drive", 0, "ready"),
            PartDiagnosis(NOW, "robot_2: drive", 0, "ready"),
            PartDiagnosis(T0, "robot_0: battery", 2, "empty"),
            PartDiagnosis(NOW, "robot_2: odd", 9, "?"),
        ]
    )
    _, links = seen(link)
    lines = text(health_table(links, {(LINK, "robot_1: laser")}, NOW))
    assert lines[0] == "Robot diagnostics /diagnostics  5 parts, 1 ERROR, 1 WARN, 1 level 9"
    values = "          hardware: l1", "          distance: 0.2"
    starts = ["✗ ERROR", "? level 9", "▲ WARN", *values, "● OK", "● OK"]
    assert [line.startswith(start) for line, start in zip(lines[1:], starts, strict=True)] == [True] * 7
    assert "robot_2: drive" in lines[-2] and "robot_10: drive" in lines[-1]
    assert "old, 20 s ago" in lines[1]
    arrangement = RowArrangement()
    arrangement.typed = "laser !drive"
    assert len(text(health_table(links, (), NOW, arrangement=arrangement))) == 2
