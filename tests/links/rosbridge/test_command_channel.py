"""Commands on a connection of their own: answered, refused, never sent later."""

import msgspec
import pytest

from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.model.commands import CancelOrder, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import place_order
from tests.support.links import finished, linked, path, phase, ready
from tests.support.watched_store import config_of

PAUSE = "/robot_0/Application_layout/Pause"


async def test_a_refusal_in_an_answer_that_went_well(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, place_order("robot_0", 0, 9999))
    assert record.stage is Stage.REFUSED
    assert "no vertex 9999" in record.detail


@pytest.mark.parametrize("order_id", [0, -1])
async def test_a_cancel_that_would_mean_all_never_leaves(server: RosbridgeServer, order_id: int) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, CancelOrder("robot_0", str(order_id)))
    assert record.stage is Stage.NOT_SENT
    assert not server.bridge.services.calls


async def test_a_command_without_a_link_is_refused_at_once_and_never_sent_later() -> None:
    server = RosbridgeServer(OhFleet(robots=1, floors=1, seed=1, quiet=True))
    await server.start()
    url, port = server.url, int(server.url.rpartition(":")[2])
    await server.stop()
    async with linked(config_of(url, 1)) as (link, store):
        state = await store.until(phase(Phase.WAITING))
        assert state.links["rosbridge"].reason == "connection refused"
        record = await finished(link, store, PauseRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT
        late = RosbridgeServer(OhFleet(robots=1, floors=1, seed=1, quiet=True), port=port)
        await late.start()
        await store.until(ready)
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED
        await late.stop()
    assert [service.rpartition("/")[2] for service, _ in late.bridge.services.calls] == ["Resume"]


async def test_a_command_under_way_ends_when_the_link_goes(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.add("/robot_0/Application_layout/Pause")
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        command_id = link.submit(PauseRobot("robot_0"))
        await store.until(lambda _: server.bridge.services.calls)
        await server.drop_clients()
        await store.until(lambda state: state.commands[-1].stage is Stage.UNKNOWN)
        # What became of it is seen after the return of the link, in the telemetry: it was not carried out.
        state = await store.until(lambda state: state.commands[-1].is_decided)
        record = state.commands[-1]
        steps = [event for event in store.events if isinstance(event, CommandAdvanced)]
    assert (record.id, record.stage) == (command_id, Stage.NOT_CONFIRMED)
    assert "outcome unknown" in record.detail and "the robot reported no pause" in record.detail
    assert [step.stage for step in steps] == [Stage.SENT, Stage.UNKNOWN]
    assert len(server.bridge.services.calls) == 1


async def test_a_call_never_answered_is_no_answer_and_then_not_confirmed(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.add("/robot_0/Application_layout/Pause")
    config = config_of(server.url, 1)
    alarms = msgspec.structs.replace(config.alarms, no_answer_after=0.3, not_confirmed_after=0.5)
    async with linked(msgspec.structs.replace(config, alarms=alarms)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, PauseRobot("robot_0"))
    assert [step.stage for step in record.steps[-2:]] == [Stage.NO_ANSWER, Stage.NOT_CONFIRMED]
    assert "no answer" in record.detail and "0.3 s" in record.detail


async def test_commands_do_not_wait_behind_subscriptions() -> None:
    """With 15 ms for each subscribe, as on a real bridge, a burst takes longer than a command may."""
    server = RosbridgeServer(OhFleet(robots=20, floors=2, seed=1, quiet=True), subscribe_delay=0.015)
    await server.start()
    async with linked(config_of(server.url, 20, 2)) as (link, store):
        await store.until(path(CommandPath.ALIVE))
        link.submit(PauseRobot("robot_0"))
        await store.until(lambda state: any(one.time_of(Stage.ACCEPTED) for one in state.commands))
        asked = [operation for operation in server.bridge.received if operation["op"] == "subscribe"]
    await server.stop()
    assert len(asked) < 20 * 12


@pytest.mark.parametrize("is_logged", [True, False])
async def test_a_call_that_an_allow_list_drops_was_not_sent_and_blames_the_list(
    ros_2: RosbridgeServer, is_logged: bool
) -> None:
    play(ros_2, [("services-glob", "robot_0")])
    if not is_logged:
        ros_2.bridge.muted.add("/rosout")
    async with linked(demo_config(Config(), ros_2.url, 2, 1, "2")) as (link, store):
        await store.until(ready)
        pause = await finished(link, store, PauseRobot("robot_0"))
        assert (pause.stage, Stage.NO_ANSWER in {step.stage for step in pause.steps}) == (
            Stage.NOT_SENT,
            not is_logged,
        )
        assert pause.detail == "the bridge does not allow it (services_glob)"
        assert (await finished(link, store, PauseRobot("robot_1"))).stage is Stage.CONFIRMED
        state = await store.until(lambda state: [one for one in state.alarms if one.holds])
        texts = [one.condition.text for one in state.alarms if one.condition.kind == "messages"]
        assert texts == [f"the bridge does not allow {PAUSE} (services_glob)"]
        again = await finished(link, store, PauseRobot("robot_0"))
        assert [step.stage for step in again.steps[-2:]] == [Stage.SENT, Stage.NOT_SENT]
    assert not [service for service, _ in ros_2.bridge.services.calls if service.startswith("/robot_0/")]


async def test_a_bridge_that_gives_no_call_up_leaves_an_unanswered_one_open(server: RosbridgeServer) -> None:
    """As those of ROS 1: its node may carry it out at any time."""
    play(server, [("services-glob", "robot_0")])
    config = config_of(server.url, 1)
    alarms = msgspec.structs.replace(config.alarms, no_answer_after=0.3)
    async with linked(msgspec.structs.replace(config, alarms=alarms)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, PauseRobot("robot_0"))
    assert [step.stage for step in record.steps[-2:]] == [Stage.NO_ANSWER, Stage.NOT_CONFIRMED]
