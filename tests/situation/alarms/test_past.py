"""What a list of the past says of an alarm."""

import pytest

from fleet_tui.model.alarm import Alarm, Condition, Priority
from fleet_tui.situation.alarms.past import told
from fleet_tui.text.language import Message


@pytest.mark.parametrize(
    ("first", "now", "text"),
    [
        ("stuck 30 s", "stuck 2 min", "stuck 30 s"),
        ("battery 9 %", "battery 8 %", "battery 9 %"),
        ("order failed: no reason reported", "order failed: No progress", "order failed: No progress"),
        ("stuck 30 s", "stuck 31 s: no odometry", "stuck 31 s: no odometry"),
    ],
)
def test_it_is_as_it_was_unless_its_cause_came_later(first: Message, now: Message, text: str) -> None:
    condition = Condition("robot_0", "stuck", Priority.HIGH, now, Message("moves"))
    assert told(Alarm(condition, 0.0, 0.0, 0.0, first_text=first)) == text
