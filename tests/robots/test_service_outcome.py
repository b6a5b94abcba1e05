"""The outcome of a command by the answer to its call, in the texts of robots and bridges."""

import json

import pytest

from fleet_tui.model.commands import Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.robots.profile import Profile
from tests.support.adapters import adapter_of
from tests.support.fleets import WIRE, place_order, recording

ORDER = place_order("r1", 0, 7)
DIED = "transport error completing service call: unable to receive data from sender, check sender's logs"


THREW = "service [/r1/x] responded with an error: b'error processing request: division by zero'"


TIMED_OUT = "Timeout exceeded while waiting for service response"


UNREACHED = "Unable to communicate with service [/r1/x], address [rosrpc://host:1]"


@pytest.mark.parametrize(
    ("values", "result", "outcome", "detail"),
    [
        ({"request_id": 1, "status": "ACCEPTED"}, True, Stage.ACCEPTED, "ACCEPTED"),
        ({"request_id": 1, "status": "executed"}, True, Stage.ACCEPTED, "executed"),
        ({"status": "REJECTED: unknown vertex 77"}, True, Stage.REFUSED, "REJECTED: unknown vertex 77"),
        ({"status": "Error 5"}, True, Stage.REFUSED, "Error 5"),
        ({"status": "order failed"}, True, Stage.REFUSED, "order failed"),
        ({"status": "terror"}, True, Stage.ACCEPTED, "terror"),
        ({"success": False, "message": "no"}, True, Stage.REFUSED, "no"),
        ({"success": False, "status": ""}, True, Stage.REFUSED, ""),
        ({"success": True, "message": "paused"}, True, Stage.ACCEPTED, "paused"),
        ("Service /x does not exist", False, Stage.REFUSED, "Service /x does not exist"),
        (DIED, False, Stage.UNKNOWN, DIED),
        (THREW, False, Stage.UNKNOWN, THREW),
        (TIMED_OUT, False, Stage.UNKNOWN, TIMED_OUT),
        (UNREACHED, False, Stage.REFUSED, UNREACHED),
        ("Unable to communicate with master!", False, Stage.REFUSED, "Unable to communicate with master!"),
        ({"status": "ACCEPTED"}, False, Stage.UNKNOWN, "{'status': 'ACCEPTED'}"),
        (None, True, Stage.UNKNOWN, "unrecognised reply: None"),
        ({}, True, Stage.UNKNOWN, "unrecognised reply: {}"),
        ({"status": None}, True, Stage.UNKNOWN, "unrecognised reply: {'status': None}"),
        ([1], True, Stage.UNKNOWN, "unrecognised reply: [1]"),
        ({"success": 0}, True, Stage.UNKNOWN, "unrecognised reply: {'success': 0}"),
        ({"success": True, "message": None}, True, Stage.ACCEPTED, ""),
        ({"status": "unknown vertex 77"}, True, Stage.REFUSED, "unknown vertex 77"),
        ({"status": "executed without error"}, True, Stage.ACCEPTED, "executed without error"),
    ],
)
def test_an_answer_is_judged_by_its_words(values: object, result: bool, outcome: Stage, detail: str) -> None:
    assert adapter_of(Profile()).outcome(ORDER, values, result) == (outcome, detail)


@pytest.mark.parametrize(
    ("command", "message", "outcome"),
    [
        (ResumeRobot("robot_1"), "already running", Stage.ACCEPTED),
        (ResumeRobot("robot_1"), "The robot is not paused", Stage.ACCEPTED),
        (PauseRobot("robot_1"), "Already paused", Stage.ACCEPTED),
        (PauseRobot("robot_1"), "not running", Stage.REFUSED),
        (PauseRobot("robot_1"), "already running", Stage.REFUSED),
        (ORDER, "already running", Stage.REFUSED),
    ],
)
def test_a_robot_that_is_as_it_was_asked_to_be_does_not_refuse(
    command: Command, message: str, outcome: Stage
) -> None:
    answer = {"success": False, "message": message}
    assert adapter_of(Profile()).outcome(command, answer, True) == (outcome, message)


REACHED_NOBODY = [
    "does not exist",
    "does not have a field",
    "message requires",
    "not a primitive type",
    "not supported between",
]


@pytest.mark.parametrize("name", sorted(path.name for path in WIRE.glob("*.jsonl*")))
def test_each_recorded_failure_of_a_call_is_told_apart(name: str) -> None:
    """Only what never reached a node was refused."""
    frames = [
        json.loads(frame["text"]) for frame in recording(name) if frame["dir"] == "in" and "text" in frame
    ]
    for frame in frames:
        if frame["op"] == "service_response" and not frame["result"]:
            stage, detail = adapter_of(Profile()).outcome(ORDER, frame["values"], False)
            refused = any(part in detail for part in REACHED_NOBODY)
            assert stage is (Stage.REFUSED if refused else Stage.UNKNOWN), detail


@pytest.mark.parametrize(
    "said",
    [
        "'<' not supported between instances of 'NoneType' and 'int'",
        "Message type Graph does not have a field vertex",
        "field data message requires an int",
    ],
)
def test_what_a_handler_throws_is_no_refusal_whatever_its_words(said: str) -> None:
    text = f'service [/r1/x] responded with an error: b"error processing request: {said}"'
    assert adapter_of(Profile()).outcome(ORDER, text, False)[0] is Stage.UNKNOWN
    assert adapter_of(Profile()).outcome(ORDER, said, False)[0] is Stage.REFUSED


def test_which_words_refuse_is_the_profiles() -> None:
    judge = adapter_of(Profile(refusals=("^no$",))).outcome
    assert judge(ORDER, {"status": "no"}, True)[0] is Stage.REFUSED
    assert judge(ORDER, {"status": "REJECTED"}, True)[0] is Stage.ACCEPTED
