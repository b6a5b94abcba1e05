"""The simulated dispatcher: bids, refusals, interruptions, and silence where nobody answers."""

import json
from typing import Any

import pytest

from fleet_tui.simulator.rmf.dispatcher import BIDDING
from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.rmf.tasks import SimTask

STORE = {"category": "patrol", "description": {"places": ["Store"], "rounds": 1}}
DIRECT = {"type": "robot_task_request", "fleet": "tiny", "robot": "robot_0", "request": STORE}


def world() -> RmfFleet:
    return RmfFleet(2, 1, seed=1, quiet=True)


def ask(it: RmfFleet, **request: Any) -> Any:
    answer = it.dispatcher.take(json.dumps(request), "q")
    return None if answer is None else answer[1]


def test_fleets_bid_before_a_robot_has_the_task() -> None:
    it = world()
    answer = ask(it, type="dispatch_task_request", request=STORE)
    assert answer["state"]["dispatch"] == {"status": "queued"}
    assert not any(one.tasks for one in it.robots.values())
    it.step(BIDDING + 0.2)
    assert [one.id for one in it.robots["tiny/robot_0"].tasks] == [answer["state"]["booking"]["id"]]


def test_without_a_bid_it_fails() -> None:
    it = world()
    ask(it, type="dispatch_task_request", request={"description": {"places": ["nowhere"]}})
    it.step(BIDDING + 0.2)
    (one,) = it.dispatcher.finished
    assert one.status == 4 and "no bid" in one.errors[0]


@pytest.mark.parametrize(
    "request_",
    [
        {**DIRECT, "robot": "stranger"},
        {"type": "cancel_task_request", "task_id": "stranger"},
        {"type": "interrupt_task_request", "task_id": "stranger"},
        {"type": "resume_task_request", "for_task": "stranger", "for_tokens": []},
        {"type": "odd"},
        {},
    ],
)
def test_nobody_answers_to_what_nobody_knows(request_: dict[str, Any]) -> None:
    assert ask(world(), **request_) is None


def test_only_the_active_task_can_be_interrupted() -> None:
    it = world()
    robot = it.robots["tiny/robot_0"]
    robot.assign(SimTask("a", ("Store",)))
    robot.assign(SimTask("b", ("Base",)))
    it.step(1.0)
    assert ask(it, type="interrupt_task_request", task_id="b")["errors"][0]["code"] == 6
    token = ask(it, type="interrupt_task_request", task_id="a")["token"]
    assert ask(it, type="resume_task_request", for_task="a", for_tokens=["9"])["errors"][0]["code"] == 7
    assert ask(it, type="resume_task_request", for_task="a", for_tokens=[token]) == {"success": True}


def test_a_task_is_cancelled_by_its_name_also_while_fleets_bid() -> None:
    it = world()
    ask(it, **DIRECT)
    assert ask(it, type="cancel_task_request", task_id="patrol.direct-1") == {"success": True}
    ask(it, type="dispatch_task_request", request=STORE)
    assert ask(it, type="cancel_task_request", task_id="patrol.dispatch-2") == {"success": True}
    it.step(BIDDING + 0.2)
    assert not any(one.tasks for one in it.robots.values())


def test_broken_json_is_answered_by_none() -> None:
    assert world().dispatcher.take("{", "q") is None
