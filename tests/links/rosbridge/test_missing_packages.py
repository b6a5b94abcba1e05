"""A bridge that was started without the robots' messages: said by the console, and asked before an order."""

from msgspec.structs import replace

from fleet_tui.cli.status.report import attention
from fleet_tui.commands.checks import problems
from fleet_tui.model.events import MessagesUnsourced
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import place_order
from tests.support.links import linked
from tests.support.watched_store import config_of


async def test_a_bridge_without_the_messages_is_told_with_the_remedy(server: RosbridgeServer) -> None:
    play(server, [("unsourced", "robot_0"), ("unsourced", "robot_1")])
    async with linked(config_of(server.url, 2)) as (_, store):
        state = await store.until(lambda state: state.links["rosbridge"].unsourced)
        state = await store.until(
            lambda state: any(alarm.condition.kind == "messages" for alarm in state.alarms)
        )
        assert attention(state)[0] == (
            "rosbridge: rosbridge lacks package OH_ressources: source its workspace and restart rosbridge"
        )
        found = problems(state, Request((place_order("robot_0", 0, 1),)), Permissions())
        assert ("queue unheard", False) in [(problem.check, problem.blocks) for problem in found]


async def test_a_bridge_that_has_them_is_not_suspected(server: RosbridgeServer) -> None:
    server.bridge.muted.update(["/robot_0/queue", "/robot_0/floor_0/graph"])
    async with linked(config_of(server.url, 2)) as (_, store):
        await store.until(lambda _: store.told(MessagesUnsourced))
        assert not store.state.links["rosbridge"].unsourced


async def test_a_node_that_was_only_slow_is_no_longer_suspected_when_it_speaks(
    server: RosbridgeServer,
) -> None:
    server.bridge.muted.update(
        f"/robot_0/{name}" for name in ("queue", "floor_0/graph", "floor_0/labeled_vertices")
    )
    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(lambda state: state.links["rosbridge"].unsourced)
        server.bridge.muted.clear()
        await store.until(lambda state: not state.links["rosbridge"].unsourced)


async def test_robots_that_speak_only_on_change_are_not_suspected() -> None:
    """Collision monitors, of which nothing comes while nothing is in the way."""
    server = RosbridgeServer(Nav2Fleet(2, 1, seed=1, quiet=True), dialect=ROS2)
    await server.start()
    config = replace(config_of(server.url, 2), profile=Profile(kind="nav2"))
    async with linked(config) as (_, store):
        await store.until(lambda _: store.told(MessagesUnsourced))
        assert not store.state.links["rosbridge"].unsourced
    await server.stop()
