"""Discovery on the wire: what it asks, what it never does, and how it ends where there is nothing to find."""

import asyncio
from collections import Counter
from collections.abc import AsyncIterator, Iterable
from contextlib import asynccontextmanager

import pytest

from fleet_tui.config.load import from_text
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.run import DIALECTS
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import FleetError, LinkError
from tests.support.discovering import discovered
from tests.support.site_faults import PLANTS

HARMLESS = {"subscribe", "unsubscribe", "call_service"}


@asynccontextmanager
async def serving(kind: str, robots: int, floors: int) -> AsyncIterator[RosbridgeServer]:
    fleet = KINDS[kind].build(robots, floors, 1, 0, 1)
    server = RosbridgeServer(fleet, dialect=DIALECTS[KINDS[kind].ros[0]])
    await server.start()
    yield server
    await server.stop()


def only_asked(server: RosbridgeServer) -> bool:
    """Tell whether only subscriptions and questions arrived."""
    calls = [one["service"] for one in server.bridge.received if one["op"] == "call_service"]
    return {one["op"] for one in server.bridge.received} <= HARMLESS and all(
        service.startswith("/rosapi/") for service in calls
    )


@pytest.mark.parametrize("kind", KINDS)
async def test_it_listens_and_asks_rosapi_and_nothing_else(kind: str) -> None:
    async with serving(kind, 3, 2) as server:
        found = await discovered(server.url)
        assert server.bridge.received and only_asked(server)
        assert not server.bridge.services.calls
    names = [KINDS[kind].named(number, number) for number in range(3)]
    assert [robot.name for robot in found.config.robots] == sorted(names)
    assert found.summary == f"3 robots ({kind}), 2 floors"
    assert found.choices == [] and found.lacks == []
    assert found.config == from_text(found.text)


async def test_set_up_is_named_where_it_is_found_also_where_robots_only_listen() -> None:
    async with serving("oh_ressources", 2, 1) as server:
        found = await discovered(server.url)
    topics = found.config.profile.topics
    assert (topics["scan"], topics["initial_pose"]) == ("/{robot}/scan", "/{robot}/initialpose")
    assert "goal" not in topics and '# goal = "/{robot}/goal"' in found.text


async def test_two_kinds_behind_one_bridge() -> None:
    fleets = [KINDS["oh_ressources"].build(2, 2, 1, 0, 2), KINDS["move_base"].build(2, 2, 1, 1, 2)]
    server = RosbridgeServer(fleets)
    await server.start()
    found = await discovered(server.url)
    assert only_asked(server)
    await server.stop()
    assert found.summary == "4 robots (2 oh_ressources, 2 move_base), 2 floors" and not found.choices
    robots = {robot.name: robot.profile for robot in found.config.robots}
    assert list(robots) == [f"robot_{n}" for n in range(4)]
    assert list(robots.values()) == ["", "move_base", "", "move_base"]


@pytest.mark.parametrize("kind", KINDS)
async def test_a_hundred_robots_cost_few_questions(kind: str) -> None:
    async with serving(kind, 100, 2) as server:
        found = await discovered(server.url)
        asked = Counter(one.get("service") for one in server.bridge.received)
    assert len(found.config.robots) == 100
    assert asked["/rosapi/publishers"] <= 200 and asked["/rosapi/service_type"] <= 50


@pytest.mark.parametrize(
    ("plant", "error", "words"),
    [
        ("a web server", LinkError, "a web server, not rosbridge"),
        ("no rosapi", FleetError, "start rosapi beside rosbridge"),
        ("a frozen rosapi", FleetError, "restart rosapi"),
    ],
)
async def test_what_can_not_be_asked(
    server: RosbridgeServer, plant: str, error: type[FleetError], words: str
) -> None:
    url = server.url
    web = await asyncio.start_server(_serve_a_page, "127.0.0.1", 0) if plant == "a web server" else None
    if web is not None:
        url = f"ws://127.0.0.1:{web.sockets[0].getsockname()[1]}"
    else:
        PLANTS[plant](server, from_text('[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n'))
    with pytest.raises(error, match=words) as caught:
        await discovered(url)
    assert str(caught.value).startswith(f"{url}: ") and isinstance(caught.value, LinkError) == (
        error is LinkError
    )
    if web is not None:
        web.close()


async def _serve_a_page(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    await reader.readuntil(b"\r\n\r\n")
    writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nhi")
    writer.close()


def _remove(server: RosbridgeServer, names: Iterable[str]) -> None:
    for name in names:
        server.bridge.topics.pop(name, None)
        server.bridge.services.types.pop(name, None)


async def test_a_bridge_without_a_robot_invents_none(server: RosbridgeServer) -> None:
    _remove(server, [name for name in server.bridge.services.types if name.startswith("/robot_")])
    found = await discovered(server.url)
    with pytest.raises(FleetError, match=r"no robot found among \d+ topics: start the robot nodes, or name"):
        _ = found.config


async def test_the_world_goes_on_untouched() -> None:
    world = OhFleet(robots=2, floors=1, seed=1, quiet=True)
    server = RosbridgeServer(world)
    await server.start()
    await discovered(server.url)
    await server.stop()
    assert not any(robot.orders for robot in world.robots.values())
