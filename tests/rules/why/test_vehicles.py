"""Tests of fleet_tui/rules/why/vehicles.py: why a vehicle stands still."""

from typing import Any

import pytest

from fleet_tui.rules.why.place import place_text
from fleet_tui.rules.why.reason import Reason, Strength
from fleet_tui.rules.why.why import reasons
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import error, node, position, state


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
            "at the end of what is released, 1 node of its order not released",
        ),
        (
            {"orderId": "o", "nodeStates": [node("b", 2)], "newBaseRequest": True},
            "waits for clearance",
            "it asks its master control for more of its route",
        ),
        ({"errors": [error("FATAL", text="hot")]}, "motorError", "fatal motorError: hot"),
        (
            {"agvPosition": position(positionInitialized=False)},
            "not localised",
            "reported by the vehicle",
        ),
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
