"""Graphs sent over a real loopback bridge: confirmed by the robot's own topics, and driven on."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest
from msgspec.structs import replace

from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import Stage
from fleet_tui.model.graph import Edge, Vertex
from fleet_tui.model.set_up.commands import SendGraph
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import F0, R0, place_order
from tests.support.links import finished, linked, ready
from tests.support.watched_store import WatchedStore, config_of

EDGES = Edge("1", "90", "91"), Edge("2", "91", "92")


@asynccontextmanager
async def console(server: RosbridgeServer, **topics: str) -> AsyncIterator[tuple[FleetLink, WatchedStore]]:
    """A console whose profile names the topics of graphs."""
    config = config_of(server.url)
    named = replace(config.profile, topics={**KINDS["oh_ressources"].profile(1)["topics"], **topics})
    alarms = replace(config.alarms, not_confirmed_after=0.5)
    async with linked(replace(config, profile=named, alarms=alarms)) as (link, store):
        await store.until(ready)
        yield link, store


def drawn(server: RosbridgeServer) -> SendGraph:
    at = server.world.robots[R0].pose
    spots = {"90": (at.x, at.y), "91": (at.x + 3.0, at.y), "92": (at.x + 3.0, at.y + 2.0)}
    vertices = tuple(Vertex(id_, *spot) for id_, spot in spots.items())
    return SendGraph(R0, F0, vertices, EDGES, labels=(("92", "New end"),))


async def test_a_graph_is_sent_confirmed_and_driven_on(server: RosbridgeServer) -> None:
    server.speed = 20.0
    sent = drawn(server)
    async with console(server) as (link, store):
        record = await finished(link, store, sent)
        assert (record.stage, record.detail) == (Stage.CONFIRMED, "by the robot")
        known = store.state.robots[R0].maps[F0]
        assert known.graph is not None and list(known.graph.vertices) == ["90", "91", "92"]
        assert known.labels == {"92": "New end"}
        assert (await finished(link, store, place_order(R0, "90", "92"))).stage is Stage.CONFIRMED
        await store.until(lambda _: server.world.robots[R0].vertex == 92)
    async with console(server) as (_, store):  # a later one gets the latched messages
        graph = store.state.robots[R0].maps[F0].graph
        assert graph is not None and list(graph.vertices) == ["90", "91", "92"]


async def test_a_graph_that_the_robot_drops_is_not_confirmed(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(SendGraph, "within", 0.0)
    async with console(server) as (link, store):
        of_another_floor = Vertex("100", 0.0, 0.0)
        sent = SendGraph(R0, F0, (of_another_floor,), labels=(("100", "Hall"),))
        record = await finished(link, store, sent)
        assert record.stage is Stage.NOT_CONFIRMED
        assert record.detail.endswith("; the robot has 20 vertices, 26 edges, 8 labels")


async def test_a_graph_is_not_published_where_nobody_listens(server: RosbridgeServer) -> None:
    async with console(server, labels_save="/{robot}/{floor}/nowhere") as (link, store):
        record = await finished(link, store, drawn(server))
    assert (record.stage, record.detail) == (Stage.NOT_SENT, f"nobody listens on /{R0}/{F0}/nowhere")
    assert 90 not in server.world.building.graph.vertices
