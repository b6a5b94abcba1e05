"""Tests of situation/alarms/vehicles."""

from fleet_tui.cli.status.report import attention
from fleet_tui.model.alarm import Priority
from fleet_tui.model.events import LinkChanged
from fleet_tui.model.link import Phase
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.alarms.trouble import to_look_at
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.news import news
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


def test_a_vehicle_that_the_broker_knows_as_gone_is_offline_with_an_alarm_from_the_first_look() -> None:
    site = VehicleSite()
    site.read("connection", message(connectionState="OFFLINE"), kept=True)
    assert next(text for text, _ in news(site.state, site.agv)) == "offline (signed off)"
    assert "agv: offline (signed off)" in attention(site.state)
    site.wait(2.1)
    assert site.alarms["offline"] == "offline (signed off)" and to_look_at(site.state) == ()
    assert reasons(site.state, site.agv)[0].name == "offline (signed off)"


def test_the_alarm_of_one_that_left_holds_from_its_last_will_on_also_over_a_lost_link() -> None:
    site = VehicleSite()
    site.read("state", state())
    site.wait(1)
    gone = message(connectionState="CONNECTIONBROKEN")
    site.read("connection", gone)

    def holds_for_seconds() -> bool:
        held = []
        for _ in range(20):
            site.wait(1)
            held += [(one.holds, one.count) for one in site.state.alarms if one.condition.kind == "offline"]
        return held == [(True, 1)] * 20

    assert holds_for_seconds()
    site.apply(LinkChanged("broker", site.now, Phase.WAITING))
    assert holds_for_seconds()
    site.apply(LinkChanged("broker", site.now, Phase.UP))
    site.read("connection", gone, kept=True)
    assert holds_for_seconds()
    site.read("connection", message(connectionState="ONLINE"))
    site.read("state", state())
    site.wait(1)
    assert [one.text for one in site.state.alarms if one.holds] == []


def test_a_last_will_that_a_live_vehicle_has_left_on_the_broker_raises_no_alarm() -> None:
    site = VehicleSite()
    site.read("connection", message(connectionState="CONNECTIONBROKEN"), kept=True)
    for _ in range(5):
        site.wait(1)
        site.read("state", state())
        assert not site.alarms and site.state.is_online(site.agv)


def test_one_that_left_is_offline_also_if_something_of_it_could_not_be_read() -> None:
    site = VehicleSite()
    for number in range(5):
        site.read("state", state(headerId=number))
        site.read("visualization", message(agvPosition={"x": "left"}))
        site.wait(1)
    site.read("connection", message(connectionState="CONNECTIONBROKEN"))
    site.wait(3)
    assert site.alarms["offline"] == "offline 4 s (connection broken)"
