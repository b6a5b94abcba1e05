"""Why a vehicle stands still."""

from typing import Any

import pytest

from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.alarms.trouble import is_odd
from fleet_tui.situation.why.place import place_text
from fleet_tui.situation.why.reason import Reason, Strength
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.news import news
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import error, message, node, position, state, state_3


def zone(id_: str, status: str = "REQUESTED", type_: str = "ACCESS") -> dict[str, str]:
    """A request of 3.0, by its schema."""
    ids = {"requestId": f"r-{id_}", "zoneId": id_, "zoneSetId": "set"}
    return {**ids, "requestType": type_, "requestStatus": status}


def corridor(edge: str) -> dict[str, Any]:
    ids = {"requestId": f"r-{edge}", "edgeId": edge, "sequenceId": 1}
    return {**ids, "requestType": "CORRIDOR", "requestStatus": "REQUESTED"}


PICKS = {"actionId": "p", "actionType": "pick", "actionStatus": "RUNNING"}


def first(**fields: Any) -> Reason:
    site = VehicleSite()
    for _ in range(4):
        site.read("state", state(**fields))
        site.wait(1)
    return reasons(site.state, site.agv)[0]


@pytest.mark.parametrize(
    ("fields", "name", "evidence"),
    [
        ({"safetyState": {"eStop": "MANUAL"}}, "e-stop (manual)", "reported by the vehicle"),
        ({"operatingMode": "MANUAL"}, "mode manual", "it takes no orders"),
        (
            {"orderId": "o", "nodeStates": [node("b", 2, released=False)]},
            "waits for clearance",
            "at the end of the released route, 1 node of its order not released",
        ),
        (
            {"orderId": "o", "nodeStates": [node("b", 2)], "newBaseRequest": True},
            "waits for clearance",
            "it asks its master control for more of its route",
        ),
        (
            {
                "orderId": "o",
                "nodeStates": [node("b", 2)],
                "zoneRequests": [zone("z1"), zone("z2", "GRANTED")],
            },
            "waits for clearance",
            "it asks its master control for zone z1",
        ),
        (
            {"zoneRequests": [zone("z3", "REVOKED", "REPLANNING")], "edgeRequests": [corridor("e4")]},
            "waits for clearance",
            "it asks its master control for a new route in zone z3 (revoked), the corridor of edge e4",
        ),
        ({"errors": [error("FATAL", text="hot")]}, "motorError", "fatal motorError: hot"),
        ({"agvPosition": position(positionInitialized=False)}, "not localised", "reported by the vehicle"),
        (
            {"orderId": "o", "nodeStates": [node("b", 2)], "safetyState": {"fieldViolation": True}},
            "blocked 4.0 s (seen)",
            "protective field violated: clear the path at the robot",
        ),
    ],
)
def test_the_cause_is_named(fields: dict[str, Any], name: str, evidence: str) -> None:
    found = first(**fields)
    assert (found.name, found.evidence, found.strength) == (name, evidence, Strength.CERTAIN)


def test_a_warning_may_be_the_cause() -> None:
    site = VehicleSite()
    site.read("state", state(errors=[error("WARNING")]))
    site.wait(4)
    found = next(one for one in reasons(site.state, site.agv) if one.name == "motorError")
    assert found.strength is Strength.POSSIBLE


def test_charging_is_a_reason_and_a_node_a_place() -> None:
    site = VehicleSite()
    site.read("state", state(batteryState={"batteryCharge": 50, "charging": True}, agvPosition=None))
    site.wait(4)
    assert any(one.name == "charging" for one in reasons(site.state, site.agv))
    assert place_text(site.agv) == "at node n0"


def test_the_hint_of_an_error_is_told_once_as_what_to_do() -> None:
    found = first(errors=[error("FATAL", text="hot", hint="cool it")])
    assert (found.evidence, found.remedy) == ("fatal motorError: hot", "cool it")


@pytest.mark.parametrize("asks", [{"zoneRequests": [zone("z")]}, {"newBaseRequest": True}])
@pytest.mark.parametrize("goes_on", [{"driving": True}, {"actionStates": [PICKS]}])
def test_one_that_asks_for_more_while_it_drives_or_works_waits_for_nothing(
    asks: dict[str, Any], goes_on: dict[str, Any]
) -> None:
    site = VehicleSite()
    left = [node("b", 2, released=False)]
    site.read("state", state(orderId="o", nodeStates=left, **asks, **goes_on))
    site.wait(1)
    assert "waits for clearance" not in [one.name for one in reasons(site.state, site.agv)]
    assert "waits for clearance" not in [text for text, _ in news(site.state, site.agv)]
    assert not is_odd(site.state, site.agv)


def test_one_that_asks_for_more_at_its_goal_and_keeps_the_node_there_waits_for_nothing() -> None:
    site = VehicleSite()
    kept = state(
        orderId="o", lastNodeId="b", lastNodeSequenceId=2, nodeStates=[node("b", 2)], newBaseRequest=True
    )
    site.read("state", kept)
    site.wait(1)
    assert "waits for clearance" not in [one.name for one in reasons(site.state, site.agv)]


@pytest.mark.parametrize(
    ("fields", "text"),
    [
        ({"operatingMode": "MANUAL"}, "mode manual"),
        ({"orderId": "o", "nodeStates": [node("b", 2)], "newBaseRequest": True}, "waits for clearance"),
        ({"maps": [{"mapId": "hall", "mapStatus": "DISABLED"}]}, "map hall is not enabled"),
    ],
)
def test_the_row_has_the_words_of_the_reason(fields: dict[str, Any], text: str) -> None:
    site = VehicleSite()
    site.read("state", state(**fields))
    site.wait(1)
    assert text in [one.name for one in reasons(site.state, site.agv)]
    assert text in [told for told, _ in news(site.state, site.agv)]


def test_a_map_that_the_vehicle_does_not_use_may_be_the_cause() -> None:
    def stored(map_id: str, status: str) -> dict[str, str]:
        return {"mapId": map_id, "mapVersion": "1", "mapStatus": status}

    site = VehicleSite()
    site.read("state", state(maps=[stored("hall", "DISABLED"), stored("yard", "ENABLED")]))
    site.wait(4)
    found = next(one for one in reasons(site.state, site.agv) if one.name == "map hall is not enabled")
    assert (found.evidence, found.strength) == ("the vehicle uses yard", Strength.POSSIBLE)
    for maps in ([stored("hall", "ENABLED")], [], None):
        site.read("state", state(maps=maps))
        assert all("enabled" not in one.name for one in reasons(site.state, site.agv))


def test_one_that_charges_by_its_power_supply_says_so() -> None:
    site = VehicleSite()
    site.read("state", state_3(operatingMode="AUTOMATIC", safetyState={}), base="vda5050/v3/KIT/0001")
    site.wait(1)
    assert "charging" in [one.name for one in reasons(site.state, site.agv)]


def test_one_that_hibernates_is_offline_for_that_reason_and_is_to_be_woken() -> None:
    site = VehicleSite()
    site.read("state", state())
    site.read("connection", message(connectionState="HIBERNATING"))
    site.wait(60)
    (found, *_) = reasons(site.state, site.agv)
    assert "offline 60 s (hibernating)" in found.name
    (alarm,) = (one for one in site.state.alarms if one.condition.kind == "offline")
    assert alarm.text == "offline 60 s (hibernating)"
    assert action_of(alarm.condition).startswith("Wake it through its master control")
