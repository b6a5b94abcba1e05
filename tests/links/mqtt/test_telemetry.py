"""A broker's messages in the store."""

import asyncio
from pathlib import Path

from fleet_tui.config.load import from_text
from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.events import Event
from fleet_tui.model.link import Phase
from fleet_tui.records.recording.play.frames import Frames
from fleet_tui.records.recording.records import EventRecord, ReceivedFrame, Record
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.broker import BrokerAccess, broker_in
from tests.support.links import linked
from tests.support.mqtt_peer import Peer
from tests.support.polling import until
from tests.support.vda_broker import SpokenFor, console_on
from tests.support.vda_fleet import ONE, config_text
from tests.support.vda_messages import BASE, message, position, state


async def test_a_vehicle_is_online_until_its_last_will(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker, "watch") as (_, store):
            await store.until(lambda state: state.robots["agv"].connection)
            vehicle.say()
            await store.until(lambda state: state.is_online(state.robots["agv"]))
            vehicle.peer.drop()
            await store.until(lambda state: not state.is_online(state.robots["agv"]))
            connection = store.state.robots["agv"].connection
            assert connection is not None and connection.value.text == "connection broken"


async def test_a_broker_that_is_restarted_is_subscribed_again(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        SpokenFor(broker)
        async with console_on(broker, "watch") as (link, store):
            broker.kill()
            await store.until(lambda state: state.links["broker"].phase is Phase.WAITING)
            broker.start()
            await store.until(lambda state: state.links["broker"].phase is Phase.UP)
            again = SpokenFor(broker)
            again.say()
            await store.until(lambda state: state.robots["agv"].pose)
            counter = link.counters["broker"]
            assert counter.topics["+/+/KIT/0001/state"].count and counter.round_trips.took


async def test_a_refused_topic_is_named(tmp_path: Path) -> None:
    with broker_in(tmp_path, BrokerAccess(refused="+/+/KIT/0001/state")) as broker:
        async with console_on(broker, "watch") as (link, store):
            await store.until(lambda state: state.robots["agv"].faults)
            refused = "+/+/KIT/0001/state: broker refuses the subscription: grant the user read access"
            assert store.state.robots["agv"].last_fault == refused
            assert link.counters["broker"].topics["+/+/KIT/0001/state"].not_subscribed


class Tape:
    """Keeps what a recording would."""

    def __init__(self) -> None:
        self.records: list[Record] = []

    def on_received(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        text = "" if is_binary else payload.decode()
        data = payload if is_binary else b""
        self.records.append(ReceivedFrame(at, at, link, channel, text, data, is_binary))

    def on_sent(self, link: str, channel: str, payload: bytes) -> None:
        pass

    def on_event(self, event: Event) -> None:
        self.records.append(EventRecord(0.0, 0.0, event))


async def test_a_recording_shows_the_same_vehicle(tmp_path: Path) -> None:
    tape = Tape()
    with broker_in(tmp_path) as broker:
        config = from_text(config_text(broker.url))
        vehicle, other = SpokenFor(broker), Peer(broker.port)
        async with linked(config, tape) as (_, store):
            await store.until(lambda state: state.robots["agv"].connection)
            other.publish(f"{BASE}/order", message(orderId="theirs", nodes=[], edges=[]))
            vehicle.say()
            vehicle.peer.publish(f"{BASE}/visualization", message(agvPosition=position(7.0)))
            vehicle.peer.publish(f"{BASE}/visualization", b"\xff")
            await store.until(lambda state: state.robots["agv"].faults and state.robots["agv"].master)
            live = store.state.robots["agv"]
    frames, played = Frames(config), initial_state(config, 0.0)
    for record in tape.records:
        played = frames.after(played, record)
    found = played.robots["agv"]
    assert (found.pose, found.vehicle, found.connection, found.faults) == (
        live.pose,
        live.vehicle,
        live.connection,
        live.faults,
    )
    assert found.master is not None and found.master.value == "order theirs"
    assert frames.counters["broker"].topics["+/+/KIT/0001/visualization"].errors == 1


async def test_robots_of_a_bridge_and_vehicles_of_a_broker_are_one_fleet(
    tmp_path: Path, server: RosbridgeServer
) -> None:
    robots = f'[[robots]]\nname = "robot_0"\n{ONE}\n'
    with broker_in(tmp_path) as broker:
        text = config_text(broker.url, robots=robots).replace("[profile", "[profiles.vda", 1)
        text = text.replace("[profile.vda5050]", "[profiles.vda.vda5050]")
        floor = '[[floors]]\nname = "floor_0"\n'
        config = from_text(f'[rosbridge]\nurl = "{server.url}"\n{floor}{text}')
        vehicle = SpokenFor(broker)
        async with linked(config) as (_, store):
            await store.until(lambda state: state.robots["agv"].connection)
            vehicle.say()
            await store.until(lambda state: all(robot.pose for robot in state.robots.values()))
            kinds = {robot.name: robot.kind.name for robot in store.state.robots.values()}
            assert kinds == {"robot_0": "oh_ressources", "agv": "vda5050"}
            assert all(state.phase is Phase.UP for state in store.state.links.values())


async def test_a_vehicle_that_comes_later_is_read_and_commanded(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        first = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            first.say()
            await store.until(lambda state: state.robots["agv"].pose)
            more = '\n[[robots]]\nname = "late"\nmanufacturer = "KIT"\nserial = "0002"\nlink = "broker"'
            config = from_text(config_text(broker.url, robots=ONE + more))
            await asyncio.to_thread(link.extend, config)
            pose = store.state.robots["agv"].pose
            assert pose is not None, "what was known stays"
            late = Peer(broker.port, "uagv/v2/KIT/0002/instantActions")
            late.publish("uagv/v2/KIT/0002/connection", message(connectionState="ONLINE"), retain=True, qos=1)
            await store.until(lambda state: state.robots["late"].connection)  # it is subscribed to
            late.publish("uagv/v2/KIT/0002/state", state(serialNumber="0002"))
            await store.until(lambda state: state.robots["late"].floor == "hall")
            assert link.counters["broker"].topics["+/+/KIT/0002/state"].count == 1
            link.submit(PauseRobot("late"))
            await until(lambda: late.told_on("uagv/v2/KIT/0002/instantActions"))
