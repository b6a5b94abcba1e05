"""Vehicles that do what the standard does not say, or leaves open: told as it is, and never as our fault."""

import codecs
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.commands.checks import problems
from fleet_tui.config.load import from_text
from fleet_tui.model.commands import PlaceOrder, Stage
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.ui.view.tables.missions import whose_mission
from tests.support.broker import BrokerAccess, broker_in
from tests.support.vda_broker import SpokenFor, console_on
from tests.support.vda_fleet import VehicleSite, config_text
from tests.support.vda_hall import hall_graph
from tests.support.vda_messages import error, message, node, position, state

ORDER = PlaceOrder("agv", (Stop(pose=Pose(5.0, 2.0)),))


def test_a_fatal_error_asks_before_an_order_as_an_emergency_stop_does() -> None:
    site = VehicleSite()
    grave = error("FATAL", "motorError"), error("CRITICAL", "scanner")
    site.read("state", state(errors=[error("WARNING", "dirty"), *grave]))
    site.wait(0.1)
    faults = [one for one in problems(site.state, Request((ORDER,)), Permissions()) if one.check == "fault"]
    assert [one.text for one in faults] == ["agv reports fatal motorError", "agv reports critical scanner"]
    assert not any(one.blocks for one in faults)


def test_an_order_of_another_master_to_nodes_that_are_unknown_here_is_shown_by_id_and_no_bad_data(
    tmp_path: Path,
) -> None:
    site = VehicleSite()
    site.apply(hall_graph(tmp_path))
    site.read("state", state(orderId="o", nodeStates=[node("their_7", 2)]))
    site.wait(2)
    assert "their_7" in whose_mission(site.state, site.agv, site.agv.orders.orders[0])
    assert site.agv.faults == 0 and "data" not in site.alarms


def test_a_map_may_have_a_number_for_a_name() -> None:
    site = VehicleSite(from_text(config_text().replace('name = "hall"', 'name = "hall"\nframe_id = "5"')))
    site.read("state", state(agvPosition={**position(), "mapId": 5}))
    assert site.agv.floor == "hall" and site.agv.faults == 0


@pytest.mark.parametrize(
    "payload", [state() + b"\0", state(lastNodeId="X").replace(b"X", b"T\xfcr"), codecs.BOM_UTF8 + state()]
)
def test_a_text_of_c_one_in_latin_1_and_one_with_a_byte_order_mark_are_read(payload: bytes) -> None:
    assert Fields.of(payload).text("lastNodeId") in ("n0", "Tür")


def test_a_clock_that_stands_still_is_the_fault_of_its_vehicle_and_ages_nothing() -> None:
    site = VehicleSite()
    for number in range(60):
        site.read("state", state(headerId=number))
        site.wait(1)
    assert site.agv.last_fault.startswith("state: clock stopped: 2026-01-02T03:04:05.678Z")
    assert not site.state.is_old(site.agv, "pose") and site.state.is_online(site.agv)
    assert list(site.alarms) == ["data"]
    moving = VehicleSite()
    for number in range(60):
        moving.read("state", state(headerId=number, timestamp=f"2026-01-02T03:04:{number:02}Z"))
        moving.wait(1)
    assert moving.agv.faults == 0


async def test_an_order_that_the_broker_does_not_pass_on_is_told_as_that(tmp_path: Path) -> None:
    with broker_in(tmp_path, BrokerAccess(writable=("state", "connection"))) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            vehicle.say()
            await store.until(lambda state: state.robots["agv"].vehicle)
            link.submit(ORDER)
            found = await store.until(lambda state: state.commands[-1].stage is Stage.NO_ANSWER)
            assert "the broker did not pass it on (rights?)" in found.commands[-1].detail


async def test_a_rejection_without_references_is_told(tmp_path: Path) -> None:
    def plain(type_: str, text: str) -> dict[str, Any]:
        return {**error(type_=type_, text=text), "errorReferences": []}

    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            vehicle.say(errors=[plain("orderError", "an older one")])
            await store.until(lambda state: state.robots["agv"].vehicle)
            link.submit(ORDER)
            await vehicle.next("order")
            vehicle.say(errors=[plain("orderError", "an older one"), plain("noRouteError", "too far")])
            found = await store.until(lambda state: state.commands[-1].stage is Stage.NO_ANSWER)
            assert found.commands[-1].detail == (
                "from agv in 5 s, and it reports noRouteError: too far: may still be carried out"
            )


def seen_at(x: float, number: int) -> bytes:
    return message(headerId=number, timestamp=stamped(number), agvPosition=position(x, 0.0))


def stamped(number: int) -> str:
    return f"2026-01-02T03:04:{number:02}Z"


def test_a_visualization_that_contradicts_the_states_is_not_believed_until_it_agrees_again() -> None:
    site = VehicleSite()

    def second(number: int, state_x: float, shown_x: float) -> float:
        site.read(
            "state", state(headerId=number, timestamp=stamped(number), agvPosition=position(state_x, 0.0))
        )
        site.wait(0.2)
        site.read("visualization", seen_at(shown_x, number))
        site.wait(0.8)
        assert site.agv.pose is not None
        return site.agv.pose.value.x

    assert [second(number, 4.0, 2.0) for number in range(6)] == [2.0, 2.0, 4.0, 4.0, 4.0, 4.0]
    fault = "visualization: position 2.0 m from that of the previous state: ignored"
    assert site.agv.last_fault == fault
    assert [second(number, 4.0, 4.2) for number in range(6, 8)] == [4.2, 4.2]


def test_a_vehicle_that_drives_between_two_states_contradicts_nothing() -> None:
    site = VehicleSite()
    for number in range(6):
        site.read("state", state(headerId=number, agvPosition=position(30.0 * number, 0.0)))
        for step in range(1, 30):
            site.wait(1)
            site.read("visualization", message(agvPosition=position(30.0 * number + step, 0.0)))
            assert site.agv.pose is not None and site.agv.pose.value.x == 30.0 * number + step
    assert "not used" not in site.agv.last_fault
