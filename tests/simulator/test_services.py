"""Services of the robots: arguments, answers, and doors for tests."""

import pytest
from websockets.asyncio.client import ClientConnection

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import Json, call

ORDER = "/robot_0/Application_layout/Execute_order"


@pytest.mark.parametrize("args", [None, {}, [], "nonsense", 7])
async def test_missing_arguments_are_zeros_and_accepted(client: ClientConnection, args: object) -> None:
    answer = await call(client, ORDER, args)
    assert (answer["values"], answer["result"]) == ({"request_id": 0, "status": "ACCEPTED"}, True)


async def test_arguments_may_come_as_a_list_in_order(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    await call(client, ORDER, [4, 2, 5])
    (order,) = server.world.robots["robot_0"].orders
    assert (order.start, order.end, server.world.robots["robot_0"].request_id) == (2, 5, 4)


TYPE = "OH_ressources/Execute_manual_orderRequest"


@pytest.mark.parametrize(
    ("args", "refusal"),
    [
        (
            {"request_id": 7.0},
            f"{TYPE} message requires a int32 for field request_id, but got a <class 'float'>",
        ),
        (
            {"end_point": None},
            f"{TYPE} message requires a int32 for field end_point, but got a <class 'NoneType'>",
        ),
        (
            {"end_point": True},
            f"{TYPE} message requires a int32 for field end_point, but got a <class 'bool'>",
        ),
        ({"end": 1}, f"Message type {TYPE} does not have a field end"),
        ({"end_point": 2**31}, "field end_point exceeds specified width [int32]"),
    ],
)
async def test_wrong_arguments_are_refused(
    server: RosbridgeServer, client: ClientConnection, args: Json, refusal: str
) -> None:
    answer = await call(client, ORDER, args)
    assert (answer["values"], answer["result"]) == (refusal, False)
    assert server.world.robots["robot_0"].orders == []
