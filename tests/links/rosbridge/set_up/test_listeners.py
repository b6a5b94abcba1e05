"""Messages that no node would take are not sent."""

from collections.abc import Mapping
from typing import Any, cast

import pytest

from fleet_tui.links.rosbridge.calls import Calls, NoAnswerError
from fleet_tui.links.rosbridge.set_up.listeners import check_listeners
from fleet_tui.robots.adapter import Publication, ServiceCall
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

POSE = Publication("/r/initialpose", "geometry_msgs/PoseWithCovarianceStamped", {})
CALL = ServiceCall("/r/settle", "std_srvs/Empty", {})


class Rosapi:
    """Answers of rosapi by question."""

    def __init__(self, **answers: Any) -> None:
        self.answers = answers

    async def call(self, service: str, _args: Mapping[str, object], _within: float) -> ServiceResponse:
        answer = self.answers.get(service.removeprefix("/rosapi/"))
        if answer is None:
            raise NoAnswerError(Message("late"))
        return ServiceResponse("1", answer, isinstance(answer, dict))


async def checked(*outgoing: Publication | ServiceCall, **answers: Any) -> None:
    await check_listeners(cast(Calls, Rosapi(**answers)), outgoing)


async def test_what_is_known_to_be_taken_is_sent() -> None:
    type_ = {"type": "geometry_msgs/msg/PoseWithCovarianceStamped"}
    await checked(POSE, topic_type=type_, subscribers={"subscribers": ["/amcl", "/rosbridge_websocket"]})
    await checked(CALL, service_type={"type": "std_srvs/srv/Empty"})


async def test_without_an_answer_it_is_sent_too() -> None:
    await checked(POSE, CALL)
    await checked(POSE, topic_type="Service does not exist", subscribers={"subscribers": None})
    await checked(POSE, topic_type={"type": ""}, subscribers={"subscribers": ["/amcl"]})


@pytest.mark.parametrize("nodes", [[], ["/rosbridge_websocket"]])
async def test_nobody_listens(nodes: list[str]) -> None:
    with pytest.raises(CommandError, match="nobody listens on /r/initialpose"):
        await checked(POSE, subscribers={"subscribers": nodes})


async def test_another_type_is_named() -> None:
    with pytest.raises(CommandError, match="/r/initialpose has type a/B, not geometry_msgs"):
        await checked(POSE, topic_type={"type": "a/B"})
    with pytest.raises(CommandError, match="/r/settle has type a/B"):
        await checked(CALL, service_type={"type": "a/B"})
