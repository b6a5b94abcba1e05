"""The simulated fleets on the wire."""

import json

from fleet_tui.simulator.rmf.fleet import GRAPHS, RESPONSES, STATES, TASKS, RmfFleet
from fleet_tui.simulator.rmf.tasks import SimTask
from fleet_tui.simulator.ros.ros2 import ROS2


def fleet() -> RmfFleet:
    return RmfFleet(2, 1, seed=1, quiet=True, period=0.0)


def test_each_fleet_has_a_message_of_its_own() -> None:
    sent = [payload.msg["name"] for topic, payload in fleet().news(ROS2) if topic == STATES]
    assert sent == ["tiny", "carrier"]
    topics = {topic.name: topic for topic in fleet().topics(0.0, ROS2)}
    history = topics[GRAPHS].history
    assert history is not None and [one.msg["name"] for one in history()] == ["tiny", "carrier"]


def test_a_request_is_answered_under_its_id() -> None:
    it = fleet()
    request = {"type": "dispatch_task_request", "request": {"description": {"places": ["Store"]}}}
    it.take({"json_msg": json.dumps(request), "request_id": "q"})
    (answer,) = [payload.msg for topic, payload in it.news(ROS2) if topic == RESPONSES]
    assert answer["request_id"] == "q" and json.loads(answer["json_msg"])["success"]
    assert not [topic for topic, _ in it.news(ROS2) if topic == RESPONSES]


def test_a_late_subscriber_gets_the_last_ten_tasks() -> None:
    it = fleet()
    for n in range(12):
        it.robots["tiny/robot_0"].assign(SimTask(f"t{n}", ("Store",)))
    list(it.news(ROS2))
    history = {topic.name: topic for topic in it.topics(0.0, ROS2)}[TASKS].history
    assert history is not None
    ids = [json.loads(one.msg["data"])["data"]["booking"]["id"] for one in history()]
    assert ids == [f"t{n}" for n in range(2, 12)]


def test_a_lost_driver_keeps_its_stamp_while_the_adapter_goes_on() -> None:
    it = fleet()
    it.robots["tiny/robot_0"].silence = 1e9

    def stamp() -> object:
        sent = [payload.msg for topic, payload in it.news(ROS2) if topic == STATES]
        return sent[0]["robots"][0]["location"]["t"]

    assert stamp() == stamp()
    assert len(list(it.health())) == 1
