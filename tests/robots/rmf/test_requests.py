"""Requests to dispatchers and fleet adapters: complete, once, with an id that their answers have."""

import json
from typing import Any

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import OrderState, Stop, at_vertices
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.model.set_up.commands import Localise
from fleet_tui.robots.adapter import Publication
from fleet_tui.text.errors import CommandError
from tests.support.rmf import ON, TINY, adapter

UNIQUE = "0123456789abcdef" * 2
ID = "fleet-tui-0123456789ab"
LABELS = {"L1": RobotMap(labels={"A": "A"}), "L2": RobotMap(labels={"B": "B", "7": "Ward"})}


def robot(*goals: Goal) -> Robot:
    return Robot(TINY, 1, "rosbridge", LABELS, kind=adapter().kind, goals={"task": goals})


def asked(command: Command, it: Robot) -> list[dict[str, Any]]:
    """The requests of a command."""
    sent = adapter().outgoing(command, 7, it, UNIQUE)
    found = []
    for n, one in enumerate(sent):
        assert isinstance(one, Publication) and one.is_request and one.name == ID
        assert (one.address, one.type) == ("/task_api_requests", "rmf_task_msgs/ApiRequest")
        assert one.message["request_id"] == (f"{ID}.{n}" if n else ID)
        found.append(json.loads(str(one.message["json_msg"])))
    return found


def test_an_order_to_a_robot_names_it_its_fleet_and_the_places() -> None:
    (found,) = asked(PlaceOrder(TINY, at_vertices("A", "7")), robot())
    assert {key: found[key] for key in ("type", "fleet", "robot")} == {
        "type": "robot_task_request",
        "fleet": "tiny",
        "robot": "t1",
    }
    request = found["request"]
    assert (request["category"], request["description"]) == ("patrol", {"places": ["A", "Ward"], "rounds": 1})
    assert request["requester"] == ID


def test_an_order_to_any_names_no_robot() -> None:
    (found,) = asked(PlaceOrder(TINY, at_vertices("B"), to_any=True), robot())
    assert found["type"] == "dispatch_task_request" and "robot" not in found
    assert found["request"]["description"]["places"] == ["B"]


@pytest.mark.parametrize("stop", [Stop("12"), Stop(pose=Pose(1.0, 2.0))])
def test_only_named_places_are_orders(stop: Stop) -> None:
    with pytest.raises(CommandError, match="named places only"):
        asked(PlaceOrder(TINY, (stop,)), robot())
    with pytest.raises(CommandError, match="destination"):
        asked(PlaceOrder(TINY, ()), robot())


def test_a_clear_cancels_each_open_task_of_this_console() -> None:
    ours = Goal("a", "a", "task", ON, is_ours=True)
    goals = ours, replace(ours, id="b", uuid="b"), replace(ours, id="c", uuid="c", is_ours=False)
    assert [one["task_id"] for one in asked(ClearOrders(TINY), robot(*goals))] == ["a", "b"]
    assert [one["task_id"] for one in asked(CancelOrder(TINY, "c"), robot(*goals))] == ["c"]


def test_a_pause_interrupts_the_task_under_way_and_a_resume_ends_every_interruption() -> None:
    queued = Goal("q", "q", "task", OrderState.QUEUED)
    (found,) = asked(PauseRobot(TINY), robot(queued, Goal("a", "a", "task", ON)))
    assert (found["type"], found["task_id"]) == ("interrupt_task_request", "a")
    held = Goal("a", "a", "task", OrderState.PAUSED, tokens=("0", "3"))
    (found,) = asked(ResumeRobot(TINY), robot(held))
    assert (found["for_task"], found["for_tokens"]) == ("a", ["0", "3"])
    with pytest.raises(CommandError, match="idle robot can't be paused"):
        asked(PauseRobot(TINY), robot(queued))
    with pytest.raises(CommandError, match="held by an emergency"):
        asked(ResumeRobot(TINY), robot(replace(held, tokens=())))


def test_a_site_without_the_topic_accepts_nothing() -> None:
    without = adapter(topics={"requests": ""})
    assert without.kind.accepts == () and not list(without.publications(TINY))
    assert without.kind.lack("pause") == "profile.topics.requests is empty: no pause"
    with pytest.raises(CommandError, match=r"topics.requests is empty"):
        without.outgoing(CancelOrder(TINY, "a"), 7, robot(), UNIQUE)
    with pytest.raises(CommandError, match="global localisation"):
        adapter().outgoing(Localise(TINY), 7, robot(), UNIQUE)
