"""The types of topics, as rosapi lists them, or none."""

import asyncio
from typing import Any, cast

import pytest

from fleet_tui.links.rosbridge.calls import Calls, rosapi_places
from fleet_tui.links.rosbridge.rosapi import topic_types
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message


class OpenConnection:
    """A connection that takes everything."""

    def send(self, _payload: bytes) -> None: ...


class LostConnection:
    """A connection without a link."""

    def send(self, _payload: bytes) -> None:
        raise LinkError(Message("no link"))


@pytest.mark.parametrize(
    "values, result, types",
    [
        ({"topics": ["/a", "/b"], "types": ["x/A", "x/B"]}, True, {"/a": "x/A", "/b": "x/B"}),
        ("Service /rosapi/topics does not exist", False, {}),
        ({"topics": "none"}, True, {}),
    ],
)
async def test_what_rosapi_lists(values: Any, result: bool, types: dict[str, str]) -> None:
    calls = Calls(cast("Connection", OpenConnection()), rosapi_places())
    asked = asyncio.ensure_future(topic_types(calls))
    await asyncio.sleep(0)
    assert calls.on_response(ServiceResponse("call:1", values, result))
    assert await asked == types


async def test_without_a_link_nothing_is_known() -> None:
    assert await topic_types(Calls(cast("Connection", LostConnection()), rosapi_places())) == {}
