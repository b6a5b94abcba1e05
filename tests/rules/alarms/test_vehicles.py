"""Tests of fleet_tui/rules/alarms/vehicles.py."""

from fleet_tui.model.alarm import Priority
from fleet_tui.rules.alarms.classes import action_of
from fleet_tui.rules.why.why import reasons
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import error, message, position, state


def priority(site: VehicleSite, kind: str) -> Priority:
    return next(one.condition.priority for one in site.state.alarms if one.condition.kind == kind)


def test_errors_are_alarms_with_their_hint() -> None:
    site = VehicleSite()
    errors = [error("WARNING", "dirtyLaser"), error("FATAL", "motorError", "too hot", "let it cool")]
    site.read("state", state(errors=errors))
    site.wait(1)
    assert site.alarms["fault"] == "fatal motorError: too hot, and 1 more"
    assert priority(site, "fault") is Priority.HIGH
    (alarm,) = site.state.alarms
    assert action_of(alarm.condition) == "let it cool"
    assert reasons(site.state, site.agv)[0].remedy == "let it cool"
    site.read("state", state())
    site.wait(5)
    assert "fault" not in site.alarms


def test_levels_have_priorities() -> None:
    for level, expected in (
        ("CRITICAL", Priority.HIGH),
        ("URGENT", Priority.MEDIUM),
        ("WARNING", Priority.LOW),
    ):
        site = VehicleSite()
        site.read("state", state(errors=[error(level)]))
        site.wait(1)
        assert priority(site, "fault") is expected


def test_an_emergency_stop_and_a_lost_place_are_alarms() -> None:
    site = VehicleSite()
    lost = position(positionInitialized=False)
    site.read("state", state(safetyState={"eStop": "MANUAL", "fieldViolation": False}, agvPosition=lost))
    site.wait(1)
    assert site.alarms["e-stop"] == "e-stop (manual)" and site.alarms["localisation"] == "not localised"


def test_a_vehicle_that_is_gone_is_an_alarm_at_once_and_keeps_its_fault() -> None:
    site = VehicleSite()
    site.read("state", state(errors=[error("FATAL")]))
    site.wait(1)
    site.read("connection", message(connectionState="CONNECTIONBROKEN"))
    site.wait(1)
    assert site.alarms["offline"] == "offline 2 s (connection broken)" and "fault" in site.alarms


def test_a_vehicle_that_was_never_seen_is_one_after_its_time() -> None:
    site = VehicleSite()
    site.read("connection", message(connectionState="OFFLINE"), kept=True)
    site.wait(30)
    assert "offline" not in site.alarms
    site.wait(6)
    assert site.alarms["offline"] == "no state yet (signed off)"
