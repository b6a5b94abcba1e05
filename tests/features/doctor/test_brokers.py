"""What is told of a broker and its vehicles."""

from typing import Any

from fleet_tui.config.load import from_text
from fleet_tui.features.doctor.broker_facts import BrokerFacts, VehicleFacts
from fleet_tui.features.doctor.brokers import broker_findings
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.model.events import PoseReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleConnection
from tests.support.vda_fleet import config_text

CONFIG = from_text(config_text(role="master"))


def found(facts: BrokerFacts) -> dict[str, Finding]:
    return {one.check: one for one in broker_findings(CONFIG, facts)}


def of_vehicle(**fields: Any) -> dict[str, Finding]:
    usual: dict[str, Any] = {
        "connection": VehicleConnection("ONLINE", "b", "2.0.0"),
        "is_kept": True,
        "vehicle": Vehicle("b", "2.0.0"),
        "pose": PoseReported("agv", 1.0, Pose(0.0, 0.0), "hall", 1.0),
        "arrivals": {"state": [1.0, 2.0], "visualization": [1.0, 1.2, 1.4]},
        "lags": [0.3],
    }
    facts = BrokerFacts(
        "broker", round_trips=[0.001], heard_for=4.0, robots={"agv": VehicleFacts(**{**usual, **fields})}
    )
    return found(facts)


def test_a_fine_vehicle() -> None:
    findings = of_vehicle()
    assert {one.verdict for one in findings.values()} == {Verdict.OK}
    measured = {check: one.measured for check, one in findings.items()}
    assert measured["connection"] == "connected" and measured["version"] == "VDA 5050 2.0.0"
    assert measured["state"] == "2 in 4.0 s" and measured["visualization"] == "5.0 Hz"
    assert measured["clock"] == "within 0.3 s of ours" and measured["floor"] == "hall (mapId hall)"


def test_what_is_wrong_has_its_remedy() -> None:
    findings = of_vehicle(
        connection=VehicleConnection("CONNECTIONBROKEN", "b", "V3.0.0"),
        vehicle=Vehicle("b", "V3.0.0"),
        pose=PoseReported("agv", 1.0, Pose(0.0, 0.0), "attic", 1.0),
        arrivals={},
        lags=[3600.0],
        problem="state: x is 1, not text",
    )
    assert {check: one.verdict for check, one in findings.items() if one.verdict is not Verdict.OK} == {
        "connection": Verdict.WARN,
        "version": Verdict.WARN,
        "state": Verdict.WARN,
        "clock": Verdict.WARN,
        "floor": Verdict.FAIL,
        "messages": Verdict.WARN,
    }
    assert findings["version"].measured == "VDA 5050 V3.0.0: read and paused, but no orders are sent"
    assert findings["clock"].measured == "3600 s behind ours"
    assert findings["floor"].remedy == 'set frame_id = "attic" in one of [[floors]]'
    assert findings["state"].measured == "none in 4 s"


def test_a_vehicle_that_was_never_seen_fails() -> None:
    one = of_vehicle(connection=None, vehicle=None)["connection"]
    assert one.verdict is Verdict.FAIL and "correct manufacturer and serial" in one.remedy


def test_rights_and_strangers_are_told() -> None:
    facts = BrokerFacts("broker", granted={"+/+/KIT/0001/state": False, "+/+/KIT/0001/order": False})
    facts.strangers = {("KIT", "9")}
    findings = found(facts)
    assert findings["read access"].verdict is Verdict.FAIL
    assert findings["read access"].measured == "broker refuses 1: +/+/KIT/0001/state"
    assert findings["vehicles"].measured == "1 on the broker not configured: KIT/9"
    facts.granted = {"+/+/KIT/0001/order": False}
    assert found(facts)["read access"].verdict is Verdict.WARN


def test_without_a_session_its_reason_is_all() -> None:
    (one,) = found(BrokerFacts("broker", reason="access denied")).values()
    assert (
        one.verdict is Verdict.FAIL
        and one.remedy == "correct url, user_file and password_file in links.broker"
    )


def test_a_connection_that_the_broker_does_not_keep_or_keeps_wrongly_is_a_warning() -> None:
    for fields in ({"is_kept": False}, {"connection": None, "is_kept": False}):
        one = of_vehicle(**fields)["connection"]
        assert (one.verdict, one.measured) == (Verdict.WARN, "not retained by the broker")
        assert one.remedy.startswith("let its software retain each connection message")
    stale = of_vehicle(connection=VehicleConnection("CONNECTIONBROKEN", "b", "2.0.0"))["connection"]
    assert stale.measured == "connection broken is retained, and the vehicle reports"


def test_positions_without_a_map_have_a_remedy_that_works() -> None:
    one = of_vehicle(pose=PoseReported("agv", 1.0, Pose(0.0, 0.0), "", 1.0))["floor"]
    assert (one.verdict, one.measured) == (Verdict.FAIL, "no mapId: drawn on none")
    assert "frame_id" not in one.remedy


def test_the_frame_of_a_remedy_is_one_that_the_configuration_reads_as_printed() -> None:
    odd = 'Halle "A" \\ 2'
    one = of_vehicle(pose=PoseReported("agv", 1.0, Pose(0.0, 0.0), odd, 1.0))["floor"]
    line = one.remedy.removeprefix("set ").removesuffix(" in one of [[floors]]")
    read = from_text(config_text().replace('name = "hall"', f'name = "hall"\n{line}'))
    assert read.floors[0].frame == odd
