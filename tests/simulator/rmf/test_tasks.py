"""States of simulated tasks."""

from fleet_tui.simulator.rmf.tasks import SimTask


def test_a_task_without_a_robot_is_assigned_to_none() -> None:
    assert "assigned_to" not in SimTask("t", ("A",)).state()
    assert "requester" not in SimTask("t", ("A",)).state()["booking"]


def test_phases_are_its_places() -> None:
    state = SimTask("t", ("A", "B", "C"), "me", "tiny", "t1", "underway", 1).state()
    assert (state["completed"], state["active"], state["pending"]) == ([1], 2, [3])
    assert state["phases"]["2"]["detail"] == "[place:B]"


def test_an_interruption_is_over_once_it_was_resumed() -> None:
    task = SimTask("t", ("A",))
    assert (task.interrupt(["x"], 1), task.interrupt([], 2)) == ("0", "1")
    assert task.resume(["0", "9"], ["y"], 3) == ["9"]
    assert task.is_held and task.resume(["0"], [], 4) == ["0"]
    assert task.resume(["1"], [], 5) == [] and not task.is_held
    assert task.state()["interruptions"]["0"]["resumed_by"]["labels"] == ["y"]
