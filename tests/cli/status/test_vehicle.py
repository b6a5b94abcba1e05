"""What a program reads of a vehicle."""

from fleet_tui.cli.status.report import report, vehicle
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import error, message, node, state


def test_a_vehicle_has_what_it_reports_and_null_for_what_it_does_not() -> None:
    site = VehicleSite()
    assert vehicle(site.state, site.agv) == {}
    site.read("connection", message(connectionState="ONLINE"))
    assert vehicle(site.state, site.agv) == {"connection": "online", "protocol": "2.0.0"}
    stopped = {"eStop": "MANUAL", "fieldViolation": True}
    site.read(
        "state",
        state(
            operatingMode="SERVICE",
            safetyState=stopped,
            errors=[error("FATAL", text="hot", hint="cool it")],
            nodeStates=[node("a", 2)],
            loads=[],
            velocity={"vx": 0.6, "vy": 0.8},
        ),
    )
    site.wait(2.0)
    (found,) = report(site.state)["robots"]
    wanted = {
        "connection": "online",
        "protocol": "2.0.0",
        "state_s": 2.0,
        "mode": "service",
        "e_stop": "manual",
        "field_violation": True,
        "driving": False,
        "speed_m_s": 1.0,
        "charging": False,
        "localised": True,
        "load": "",
        "last_node": "n0",
        "nodes_left": ["a"],
        "waits_for_clearance": False,
        "errors": [{"type": "motorError", "level": "fatal", "text": "hot", "hint": "cool it"}],
    }
    assert wanted.items() <= found.items()
    site.read("state", state(operatingMode="", safetyState={}, batteryState={}))
    assert {**vehicle(site.state, site.agv), "errors": None}.items() >= {
        "mode": None,
        "e_stop": None,
        "field_violation": None,
        "speed_m_s": None,
        "charging": None,
        "load": None,
    }.items()
