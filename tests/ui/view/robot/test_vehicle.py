"""A vehicle's own lines on its page."""

from fleet_tui.situation.robots import NO_STATES, silence
from fleet_tui.ui.view.robot.sections import factsheet_rows, vehicle_rows
from fleet_tui.ui.view.tables.news import news
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import error, message, state


def texts(site: VehicleSite) -> list[str]:
    rows = [*vehicle_rows(site.state, site.agv), *factsheet_rows(site.agv)]
    return [" ".join("".join(text for text, _ in row).split()) for row in rows]


def test_what_is_reported_is_shown_and_no_more() -> None:
    site = VehicleSite()
    assert texts(site) == []
    site.read("connection", message(connectionState="ONLINE"))
    assert texts(site) == ["Broker connected, VDA 5050 2.0.0"]
    site.read("state", state(loads=[{"loadType": "EPAL"}], velocity={"vx": -0.3, "vy": 0.4}))
    site.read("order", message(orderId="o", nodes=[], edges=[]))
    site.read("factsheet", message(physicalParameters={"speedMax": 1.5}))
    assert texts(site) == [
        "Broker connected, VDA 5050 2.0.0",
        "Mode automatic",
        "Node n0",
        "Load EPAL",
        "Charging no",
        "Speed 0.50 m/s",
        "Master order o, 0 s ago",
        "speedMax 1.5",
    ]


def test_hostile_text_stays_text() -> None:
    site = VehicleSite()
    site.read(
        "state", state(lastNodeId="\x1b[2J", errors=[error(type_="\x1b]0;x\x07")], operatingMode="\u202e")
    )
    shown = [*texts(site), *(text for text, _ in news(site.state, site.agv))]
    assert not any(letter in text for text in shown for letter in "\x1b\x07\u202e")


def test_the_row_of_a_vehicle_has_its_news() -> None:
    site = VehicleSite()
    site.read("connection", message(connectionState="ONLINE"), kept=True)
    assert [text for text, _ in news(site.state, site.agv)] == ["no state yet (connected)"]
    assert silence(site.state, site.agv).remedy == NO_STATES
    stopped = {"eStop": "MANUAL", "fieldViolation": False}
    site.read("state", state(safetyState=stopped, operatingMode="SERVICE", errors=[error("FATAL")]))
    assert [text for text, _ in news(site.state, site.agv)] == [
        "e-stop (manual)",
        "motorError",
        "mode service",
    ]


def test_the_maps_and_zone_sets_that_it_uses_are_listed() -> None:
    site = VehicleSite()
    maps = [{"mapId": "hall", "mapStatus": "ENABLED"}, {"mapId": "yard", "mapStatus": "DISABLED"}]
    sets = [
        {"zoneSetId": "day", "zoneSetStatus": "ENABLED"},
        {"zoneSetId": "night", "zoneSetStatus": "DISABLED"},
    ]
    site.read("state", state(maps=maps, zoneSets=sets))
    assert {"Maps hall", "Zones day"} <= set(texts(site))
