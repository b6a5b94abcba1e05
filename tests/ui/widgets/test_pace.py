"""The pace of views."""

from pytest import MonkeyPatch

from fleet_tui.ui.widgets import pace
from fleet_tui.ui.widgets.pace import Pace


def test_it_is_due_after_its_time_and_at_once_for_another_key(monkeypatch: MonkeyPatch) -> None:
    now = 100.0
    monkeypatch.setattr(pace, "monotonic", lambda: now)
    every_second = Pace(1.0)
    assert every_second.is_due("a") and not every_second.is_due("a")
    assert every_second.is_due("b")
    now = 100.9
    assert not every_second.is_due("b")
    now = 101.0
    assert every_second.is_due("b")
