"""Answers to the calls of one command: the worst of them is its end, reported once."""

import asyncio
import json
from typing import cast

import pytest

from fleet_tui.links.rosbridge.answers import Answers, decoded
from fleet_tui.links.rosbridge.calls import Calls, PendingCall, rosapi_places
from fleet_tui.links.rosbridge.services import Services
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.robots.adapter import ServiceCall
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.state.store import Store
from tests.support.adapters import adapter_of
from tests.support.ear import Ear
from tests.support.fleets import LINK, R0, T0, fleet
from tests.support.watched_store import config_of

PAUSE = PauseRobot(R0)
OUTGOING = ServiceCall("/pause", "std_srvs/Trigger", {})


class Deaf:
    """A connection that sends and hears nothing."""

    def send(self, _payload: bytes) -> None: ...


class Waiting:
    """Answers that are waited for, and what is reported of commands."""

    def __init__(self) -> None:
        self.calls = Calls(cast("Connection", Deaf()), rosapi_places())
        self.told: list[tuple[int, Stage, str]] = []
        self.answers = Answers(
            LINK,
            self.calls,
            Services(self.calls, {}),
            {R0: adapter_of(config_of("ws://x").profile)},
            Writer(Store(fleet())),
            0.01,
            lambda *told: self.told.append(told),
        )

    def wait(self, count: int) -> tuple[list[PendingCall], "asyncio.Task[None]"]:
        pending = [self.calls.start("/pause", {}, 1.0) for _ in range(count)]
        told = [(OUTGOING, call) for call in pending]
        return pending, asyncio.create_task(self.answers.wait(7, PAUSE, told, T0))

    def answer(self, call: PendingCall, success: bool, message: str) -> None:
        values = {"success": success, "message": message}
        self.calls.on_response(ServiceResponse(call.id, values, True))


@pytest.fixture
async def waiting() -> Waiting:
    return Waiting()


async def test_the_worst_of_several_answers_is_the_end(waiting: Waiting) -> None:
    pending, task = waiting.wait(3)
    for call, success in zip(pending, (True, False, True), strict=True):
        waiting.answer(call, success, "key switch is off" if not success else "")
    await task
    ((id_, stage, detail),) = waiting.told
    assert (id_, stage) == (7, Stage.REFUSED) and "key switch is off" in detail


async def test_an_answer_after_its_deadline_is_told_after_all(waiting: Waiting) -> None:
    (call,), task = waiting.wait(1)
    while not waiting.told:  # noqa: ASYNC110  # its own deadline tells
        await asyncio.sleep(0.001)
    assert waiting.told[0][1] is Stage.NO_ANSWER
    waiting.answer(call, True, "paused")
    await task
    assert [stage for _, stage, _ in waiting.told] == [Stage.NO_ANSWER, Stage.ACCEPTED]


async def test_one_that_never_comes_stays_no_answer(waiting: Waiting) -> None:
    _, task = waiting.wait(1)
    await task
    assert [stage for _, stage, _ in waiting.told] == [Stage.NO_ANSWER]


async def test_a_lost_link_and_a_fault_of_our_own_leave_the_end_unknown(
    waiting: Waiting, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, lost = waiting.wait(1)
    await asyncio.sleep(0.001)
    waiting.calls.on_lost()
    await lost
    monkeypatch.setattr(waiting.answers, "_learn", lambda *_: 1 / 0)
    (call,), broken = waiting.wait(1)
    waiting.answer(call, True, "")
    await broken
    (_, first, detail), (_, second, error) = waiting.told
    assert (first, second) == (Stage.UNKNOWN, Stage.UNKNOWN)
    assert "link lost" in detail and error.startswith("internal error: division")


def test_frames_are_recorded_whatever_is_in_them() -> None:
    ear = Ear()
    good = {"op": "service_response", "id": "1", "service": "/s", "values": {}, "result": True}
    frames = [(json.dumps(good).encode(), False), (b"{", False), (b"\xff", True)]
    found = [decoded(ear, "rosbridge", payload, is_binary) for payload, is_binary in frames]
    assert isinstance(found[0], ServiceResponse) and found[1:] == [None, None]
    assert [frame[:3] for frame in ear.heard_frames] == [
        ("rosbridge", "commands", payload) for payload, _ in frames
    ]
