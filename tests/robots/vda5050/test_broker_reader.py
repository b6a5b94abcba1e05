"""Messages with their topics, counted and read."""

import pytest

from fleet_tui.model import events
from fleet_tui.model.vehicles.events import ConnectionReported, MessageKept, VehicleReported
from fleet_tui.robots.vda5050.frames import BrokerMessage, frame_of
from fleet_tui.situation.facts import AGE_UNKNOWN
from fleet_tui.situation.robots import absence
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import BASE, message, state


def test_messages_of_configured_vehicles_are_read_and_others_ignored() -> None:
    site = VehicleSite()
    assert any(isinstance(one, VehicleReported) for one in site.read("state", state()))
    assert site.read("state", state(), base="uagv/v2/KIT/0002") == ()
    assert site.read("anything", state()) == () and site.read("state", b"", base="x") == ()
    counted = site.reader.counter.topics["+/+/KIT/0001/state"]
    assert counted.count == 1 and counted.last is not None and counted.last.is_whole


def test_a_vehicle_may_be_known_by_its_serial_number_alone() -> None:
    from fleet_tui.config.load import from_text
    from tests.support.vda_fleet import config_text

    robots = '[[robots]]\nname = "agv"\nserial = "0001"\nlink = "broker"'
    site = VehicleSite(from_text(config_text(robots=robots)))
    assert site.read("state", state()) and site.read("state", state(), base="uagv/v2/ANY/0001")


def test_a_kept_state_is_not_fresh_and_not_shown() -> None:
    site = VehicleSite()
    for name in ("state", "order"):
        (told,) = site.read(name, state(), kept=True)
        assert isinstance(told, MessageKept)
        assert told.text.startswith(f"{name}: retained by the broker, of unknown age: not shown")
    assert site.agv.vehicle is None and site.agv.pose is None and site.agv.last_received is None
    for seconds in (0.2, 40.0):
        site.wait(seconds)
        fact = absence(site.state, site.agv)
        assert fact is not None and fact.kind is AGE_UNKNOWN, "nobody spoke, and nothing is bad"
    (found,) = site.read("connection", message(connectionState="ONLINE"), kept=True)
    assert isinstance(found, ConnectionReported) and found.is_kept


def two_vehicles() -> VehicleSite:
    from fleet_tui.config.load import from_text
    from tests.support.vda_fleet import ONE, config_text

    other = ONE.replace('"agv"', '"other"').replace('"0001"', '"0002"')
    return VehicleSite(from_text(config_text(robots=f"{ONE}\n{other}")))


OTHER = "uagv/v2/KIT/0002"
OLD, NOW = "2026-01-02T03:03:25.000Z", "2026-01-02T03:04:05.000Z"


def test_a_kept_state_is_as_old_as_its_timestamp_by_the_clock_of_another_vehicle() -> None:
    site = two_vehicles()
    site.read("state", state(timestamp=NOW), base=OTHER)
    site.read("state", state(timestamp=OLD), kept=True)
    assert site.agv.last_received == site.now - 40.0 and not site.state.is_online(site.agv)
    assert site.agv.pose is not None and site.agv.pose.at == site.now - 40.0
    assert site.state.is_online(site.state.robots["other"]) and site.agv.faults == 0


def test_a_kept_state_is_dated_once_another_vehicle_reports() -> None:
    site = two_vehicles()
    (told,) = site.read("state", state(timestamp=OLD), kept=True)
    assert isinstance(told, MessageKept) and site.agv.pose is None
    site.wait(2.0)
    site.read("state", state(timestamp=NOW), base=OTHER)
    assert site.agv.last_received == site.now - 40.0 and not site.state.is_online(site.agv)


AHEAD, RECENT = "2026-01-02T05:04:05.000Z", "2026-01-02T03:03:55.000Z"


def test_a_kept_state_from_a_clock_that_is_ahead_stays_of_unknown_age() -> None:
    site = two_vehicles()
    site.read("state", state(timestamp=NOW), base=OTHER)
    (told,) = site.read("state", state(timestamp=AHEAD), kept=True)
    assert isinstance(told, MessageKept) and not site.state.is_online(site.agv)
    site.wait(7200.0)
    site.read("state", state(timestamp=AHEAD), base=OTHER)
    assert site.agv.vehicle is None and not site.state.is_online(site.agv), "it does not become new later"


def test_a_kept_state_that_a_new_link_brings_again_replaces_no_later_one() -> None:
    site = two_vehicles()
    site.read("state", state(timestamp=NOW, lastNodeId="n7"))
    site.read("state", state(timestamp=OLD, lastNodeId="n1"), kept=True)
    assert site.agv.vehicle is not None and site.agv.vehicle.value.last_node == "n7"
    assert site.state.is_fresh(site.agv, "vehicle")


@pytest.mark.parametrize("order", [("connection", "state"), ("state", "connection")])
def test_a_kept_state_is_no_sign_of_life_beside_a_kept_last_will(order: tuple[str, str]) -> None:
    site = two_vehicles()
    site.read("state", state(timestamp=NOW), base=OTHER)
    gone = message(connectionState="CONNECTIONBROKEN")
    for name in order:
        site.read(name, gone if name == "connection" else state(timestamp=RECENT), kept=True)
    assert site.agv.last_received == site.now - 10.0 and not site.state.is_online(site.agv)
    site.wait(1.0)
    site.read("visualization", state(timestamp=NOW))
    assert site.state.is_online(site.agv)


def test_a_live_state_leaves_nothing_of_a_kept_one() -> None:
    site = two_vehicles()
    site.read("state", state(timestamp=OLD), kept=True)
    site.read("state", state(timestamp=NOW))
    site.read("state", state(timestamp=NOW), base=OTHER)
    assert site.agv.last_received == site.now and site.state.is_online(site.agv)


def test_what_can_not_be_read_names_its_topic() -> None:
    site = VehicleSite()
    (found,) = site.read("state", b"no json")
    assert isinstance(found, events.MessageRejected) and found.text.startswith(f"{BASE}/state: no JSON")
    *read, rejected = site.read("state", state(batteryState={"batteryCharge": "full"}))
    assert read and isinstance(rejected, events.MessageRejected)
    assert rejected.text == "state: batteryState.batteryCharge is 'full', not a number"
    assert site.reader.counter.topics["+/+/KIT/0001/state"].errors == 2 and site.agv.faults == 2


def test_frames_of_a_recording_are_read_alike() -> None:
    site = VehicleSite()
    direct = site.read("state", state())
    site.reader.recount()
    frame = frame_of(BrokerMessage(f"{BASE}/state", state()))
    assert site.reader.read(*frame, site.now) == direct
    (rejected,) = site.reader.read(b"nothing", False, site.now)
    assert isinstance(rejected, events.FrameRejected)


def test_a_message_over_the_limit_names_the_key() -> None:
    site = VehicleSite()
    (found,) = site.reader.too_large(f"{BASE}/state", 3_000_000_000)
    assert isinstance(found, events.MessageRejected) and found.text.endswith(
        "raise links.broker.max_message_mb"
    )
    (unknown,) = site.reader.too_large("any", 1)
    assert isinstance(unknown, events.FrameRejected)


def test_values_of_any_depth_raise_nothing() -> None:
    site, told = VehicleSite(), set[type]()
    for depth in range(300, 1005):
        for text in ('{"orderId": %s%s}', '{"nodeStates": [{"nodePosition": %s%s}]}'):
            payload = (text % ("[" * depth, "]" * depth)).encode()
            told |= {type(one) for one in (*site.read("state", payload), *site.read("state", payload))}
    assert events.MessageRejected in told


def test_half_a_surrogate_pair_is_no_text() -> None:
    site = VehicleSite()
    (told,) = site.read("state", b'{"operatingMode": "\\ud800"}')
    assert isinstance(told, events.MessageRejected) and "no JSON" in told.text
    assert site.agv.vehicle is None
