"""States of tasks: whose, in which state, interrupted by whom, described for people."""

from typing import Any

import pytest

from fleet_tui.model.fleets.events import TaskReported
from fleet_tui.model.order import OrderState
from fleet_tui.text.errors import WireError
from tests.support.rmf import CARRIER, adapter, read, task, update


def taken(**more: Any) -> TaskReported:
    (found,) = read(adapter(), "tasks", update(task(**more)))
    assert isinstance(found, TaskReported)
    return found


@pytest.mark.parametrize(
    ("status", "state"),
    [
        ("queued", OrderState.QUEUED),
        ("underway", OrderState.IN_PROCESS),
        ("blocked", OrderState.IN_PROCESS),
        ("completed", OrderState.DONE),
        ("canceled", OrderState.CANCELLED),
        ("killed", OrderState.CANCELLED),
        ("failed", OrderState.FAILED),
        ("a new one", None),
    ],
)
def test_each_status_has_a_state_and_keeps_its_word(status: str, state: OrderState | None) -> None:
    found = taken(status=status).task
    assert (found.state, found.word) == (state, status)


def test_a_task_belongs_to_the_robot_that_it_is_assigned_to() -> None:
    assert taken(robot=CARRIER).robot == CARRIER
    assert not read(adapter(), "tasks", update(task(assigned_to=None)))


def test_an_interruption_is_open_until_it_was_resumed() -> None:
    over = {"unix_millis_request_time": 1, "labels": [], "resumed_by": {"labels": []}}
    still = {"unix_millis_request_time": 2, "labels": ["rmf-web"]}
    found = taken(interruptions={"0": over, "1": still}).task
    assert (found.state, found.tokens) == (OrderState.PAUSED, ("1",))
    assert taken(interruptions={"0": over}).task.state is OrderState.IN_PROCESS
    assert taken(interruptions={"1": still}, status="canceled").task.state is OrderState.CANCELLED


def test_an_emergency_holds_a_task_and_no_console_resumes_it() -> None:
    found = taken(interruptions={"0": {"labels": ["emergency pullover"]}}).task
    assert (found.state, found.tokens) == (OrderState.PAUSED, ())


def test_it_is_described_by_its_active_phase_else_by_itself() -> None:
    phases = {"2": {"id": 2, "category": "Go", "detail": "to [place:A]"}}
    assert taken(detail="all of it", phases=phases, active=2).task.label == "patrol: to A"
    assert taken(detail={"places": ["A", "B"]}).task.label == "patrol: places: A, B"
    assert taken(category="").task.label == "task"


def test_an_estimate_is_in_seconds_if_it_can_be_one() -> None:
    assert taken(estimate_millis=4200).seconds == 4.2
    assert taken(estimate_millis=0).seconds is None
    assert taken(estimate_millis=10**15).seconds is None


@pytest.mark.parametrize("id_", ["", "x" * 300])
def test_a_name_that_is_none_is_refused(id_: str) -> None:
    with pytest.raises(WireError, match=r"booking.id"):
        read(adapter(), "tasks", update(task(id_)))
