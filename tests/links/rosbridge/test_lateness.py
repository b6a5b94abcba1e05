"""Questions on the connection of the telemetry: the bridge answers as late as its messages come."""

from fleet_tui.links.rosbridge import command_channel, lateness
from fleet_tui.model.events import BridgeAnswered
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.links import linked
from tests.support.watched_store import WatchedStore, config_of


def answers(store: WatchedStore) -> list[BridgeAnswered]:
    return [one for one in store.told(BridgeAnswered) if isinstance(one, BridgeAnswered)]


async def test_a_bridge_tells_the_clock_of_its_site_and_answers_at_once(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (_, store):
        state = await store.until(lambda state: state.links["rosbridge"].clock is not None)
        assert state.links["rosbridge"].late == 0.0 and answers(store)[0].after < 1.0


async def test_a_late_bridge_is_known_by_its_answer(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(lambda state: state.links["rosbridge"].clock is not None)
        server.bridge.services.lag = 1.5
        state = await store.until(lambda state: state.links["rosbridge"].late > 1.0)
        assert state.links["rosbridge"].late < 3.0, "not what it takes to wait for rosapi"
        server.bridge.services.lag = 0.0
        await store.until(lambda state: state.links["rosbridge"].late < 0.1)


async def test_a_frozen_rosapi_is_no_late_bridge(server: RosbridgeServer) -> None:
    play(server, [("frozen-rosapi", "robot_0")])
    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(lambda _: len(answers(store)) >= 2)
        assert all(one.after < 1.0 and one.stamp is None for one in answers(store))
        assert store.state.links["rosbridge"].late == 0.0


def test_a_bridge_that_answers_in_time_is_not_silent() -> None:
    """Where no robot has anything to say, its answers are all that comes; commands must still be sent."""
    assert lateness.EVERY + lateness.QUICK < command_channel.LONGEST_SILENCE
