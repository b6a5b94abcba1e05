"""Calls with a deadline: each ends once, whatever comes and when."""

import asyncio
import json
import time
from typing import Any, cast

import pytest

from fleet_tui.links.rosbridge.calls import OWN_WORD, Calls, LinkLostError, NoAnswerError, rosapi_places
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message


class Sent:
    """The sending side of a connection."""

    def __init__(self) -> None:
        self.frames: list[dict[str, Any]] = []
        self.is_up = True

    def send(self, payload: bytes) -> None:
        if not self.is_up:
            raise LinkError(Message("no link"))
        self.frames.append(json.loads(payload))


@pytest.fixture
def sent() -> Sent:
    return Sent()


@pytest.fixture
def calls(sent: Sent) -> Calls:
    return Calls(cast("Connection", sent), rosapi_places())


def answer(id_: str, values: object = None) -> ServiceResponse:
    return ServiceResponse(id_, values, True)


async def test_answers_find_their_calls_in_any_order_and_once(calls: Calls, sent: Sent) -> None:
    one, other = (calls.start(service, {"n": n}, 1.0) for n, service in enumerate(("/a", "/b")))
    assert [frame["service"] for frame in sent.frames] == ["/a", "/b"]
    assert [frame["args"] for frame in sent.frames] == [{"n": 0}, {"n": 1}]
    assert one.id != other.id
    assert calls.on_response(answer(other.id, "b")) and calls.on_response(answer(one.id, "a"))
    assert not calls.on_response(answer(one.id, "again"))
    assert (await calls.wait(one, 1.0)).values == "a" and (await calls.wait(other, 1.0)).values == "b"
    calls.forget(one)
    assert not calls.on_response(answer(one.id)) and not calls.on_response(answer("call:99"))


async def test_what_is_asked_of_rosapi_waits_for_its_turn_and_no_other_call_does(
    calls: Calls, sent: Sent
) -> None:
    asked = ["/rosapi/topics", "/rosapi/services", "/rosapi/get_time", OWN_WORD, "/robot_0/pause"]
    open_calls = [asyncio.ensure_future(calls.call(service, {}, 5.0)) for service in asked]
    await asyncio.sleep(0)
    assert [frame["service"] for frame in sent.frames] == [*asked[:2], *asked[3:]]
    calls.on_response(answer(sent.frames[0]["id"]))
    await open_calls[0]
    assert sent.frames[-1]["service"] == asked[2]
    for frame in sent.frames[1:]:
        calls.on_response(answer(frame["id"]))
    await asyncio.gather(*open_calls)


@pytest.mark.parametrize("is_lost", [False, True])
async def test_a_question_keeps_its_place_at_rosapi_though_nobody_waits_for_its_answer_any_more(
    calls: Calls, sent: Sent, is_lost: bool
) -> None:
    ended = await asyncio.gather(
        *(calls.call("/rosapi/get_time", {}, 0.01) for _ in range(2)), return_exceptions=True
    )
    assert [type(error) for error in ended] == [NoAnswerError, NoAnswerError]
    third = asyncio.ensure_future(calls.call("/rosapi/topics", {}, 5.0))
    await asyncio.sleep(0)
    assert len(sent.frames) == 2, "rosapi works on both"
    if is_lost:
        calls.on_lost()
    else:
        assert not calls.on_response(answer(sent.frames[0]["id"]))
    await asyncio.sleep(0.01)
    calls.on_response(answer(sent.frames[2]["id"]))
    await third


async def test_a_question_that_gets_no_place_at_rosapi_ends_in_time_and_is_not_sent(
    calls: Calls, sent: Sent
) -> None:
    unanswered = [asyncio.ensure_future(calls.call("/rosapi/topics", {}, 60.0)) for _ in range(2)]
    await asyncio.sleep(0)
    with pytest.raises(NoAnswerError, match="left others unanswered"):
        await calls.call("/rosapi/get_time", {}, 0.7)
    assert len(sent.frames) == 2
    for frame in sent.frames:
        calls.on_response(answer(frame["id"]))
    await asyncio.gather(*unanswered)


async def test_the_time_of_an_answer_begins_when_its_question_is_sent(calls: Calls, sent: Sent) -> None:
    before = [asyncio.ensure_future(calls.call("/rosapi/topics", {}, 60.0)) for _ in range(2)]
    timed = asyncio.ensure_future(calls.timed("/rosapi/get_time", {}, 60.0))
    await asyncio.sleep(30.0)
    for sent_before in list(sent.frames):
        calls.on_response(answer(sent_before["id"]))
    await asyncio.gather(*before)
    await asyncio.sleep(1.0)
    calls.on_response(answer(sent.frames[-1]["id"]))
    assert (await timed)[0] < 2.0


async def test_a_call_without_an_answer_may_be_waited_for_again(calls: Calls) -> None:
    call = calls.start("/s", {}, 1.0)
    with pytest.raises(NoAnswerError, match="from /s in 0 s: may still be carried out"):
        await calls.wait(call, 0.0)
    calls.on_response(answer(call.id, "late"))
    assert (await calls.wait(call, 1.0)).values == "late"


async def test_a_lost_link_ends_every_open_call(calls: Calls) -> None:
    open_, answered = calls.start("/a", {}, 1.0), calls.start("/b", {}, 1.0)
    calls.on_response(answer(answered.id, "b"))
    calls.on_lost()
    with pytest.raises(LinkLostError, match="may still be carried out"):
        await calls.wait(open_, 1.0)
    assert (await calls.wait(answered, 1.0)).values == "b"


async def test_a_call_that_was_not_sent_waits_for_nothing(calls: Calls, sent: Sent) -> None:
    sent.is_up = False
    with pytest.raises(LinkError, match="no link"):
        await calls.call("/s", {}, 1.0)
    sent.is_up = True
    task = asyncio.create_task(calls.call("/s", {}, 1.0))
    await asyncio.sleep(0)
    assert calls.on_response(answer("call:2", "well"))
    assert (await task).values == "well"
    assert not calls.on_response(answer("call:2"))


async def test_time_in_which_this_process_did_not_run_is_no_time_waited(calls: Calls) -> None:
    """What arrived meanwhile is read after it, a few turns of the loop later."""
    call, loop = calls.start("/s", {}, 1.0), asyncio.get_running_loop()

    def read(turns: int) -> None:
        if turns:
            loop.call_soon(read, turns - 1)
        else:
            calls.on_response(answer(call.id, "well"))

    def stop() -> None:
        time.sleep(0.4)  # the stop itself
        read(5)

    loop.call_soon(stop)
    assert (await calls.wait(call, 0.2)).values == "well"


async def test_a_process_that_is_starved_for_long_gives_up_all_the_same(calls: Calls) -> None:
    call = calls.start("/s", {}, 1.0)
    with pytest.raises(NoAnswerError):
        await calls.wait(call, 0.01)
