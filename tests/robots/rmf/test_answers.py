"""Answers to requests by their ids, and tasks for which no robot was found."""

import json
from typing import Any

import pytest

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleets.events import DispatchFailed, RequestAnswered
from fleet_tui.text.errors import WireError
from tests.support.rmf import adapter, read

ID = "fleet-tui-0123456789ab"


def response(answer: object, id_: str = ID, type_: int = 2) -> dict[str, Any]:
    return {"type": type_, "json_msg": json.dumps(answer), "request_id": id_}


def test_an_accepted_order_has_the_id_of_its_task() -> None:
    answer = {"success": True, "state": {"booking": {"id": "patrol-1"}, "status": "queued"}}
    assert read(adapter(), "responses", response(answer, f"{ID}.1")) == [
        RequestAnswered(ID, 5.0, Stage.ACCEPTED, "", "patrol-1")
    ]


@pytest.mark.parametrize(
    ("errors", "reason"),
    [
        ([{"code": 6, "category": "Invalid", "detail": "queued"}], "Invalid: queued"),
        (["plain"], "plain"),
        ([], "no reason given"),
    ],
)
def test_a_refused_one_has_the_reason(errors: list[object], reason: str) -> None:
    (found,) = read(adapter(), "responses", response({"success": False, "errors": errors}))
    assert found == RequestAnswered(ID, 5.0, Stage.REFUSED, reason)


def test_what_asks_for_patience_or_is_another_programs_is_no_answer() -> None:
    assert not read(adapter(), "responses", response({}, type_=1))
    assert not read(adapter(), "responses", response({"success": True}, "rmf-web-1"))


def test_an_answer_without_success_is_refused() -> None:
    with pytest.raises(WireError, match="success"):
        read(adapter(), "responses", response({}))


def test_a_task_that_no_fleet_took_is_named_with_the_reasons() -> None:
    error = json.dumps({"category": "Not Feasible", "detail": "no bid"})
    states = {
        "active": [{"task_id": "a", "status": 1, "errors": []}, "odd"],
        "finished": [
            {"task_id": "b", "status": 4, "errors": [error]},
            {"task_id": "c", "status": 3, "errors": []},
            {"task_id": "d", "status": 5, "errors": []},
        ],
    }
    assert read(adapter(), "dispatches", states) == [
        DispatchFailed("b", 5.0, "no fleet took the task: Not Feasible: no bid"),
        DispatchFailed("d", 5.0, "cancelled before a robot had it", True),
    ]
