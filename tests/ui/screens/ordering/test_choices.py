"""Choices of the order form: places of the robot it is for."""

import msgspec
from msgspec.structs import replace
from textual.widgets import Input

from fleet_tui.commands.checks import robot_problems
from fleet_tui.commands.language.favourites import Favourite
from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.events import Event, GraphReceived, ObstacleReported, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role, RouteGraph, Vertex
from fleet_tui.model.kind import ORDER, Kind
from fleet_tui.model.problem import Problem
from fleet_tui.model.vehicles.vehicle import VehicleFeatures
from fleet_tui.text.language import Message
from fleet_tui.ui.screens.ordering.choices import charge_first, choices, condition, lines, scope, warnings
from fleet_tui.ui.screens.ordering.form import OrderForm
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import (
    F0,
    R0,
    T0,
    battery,
    fleet,
    graph,
    labels,
    link_up,
    of_kinds,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.ordering import order, place
from tests.support.planted_console import SITE, planted
from tests.support.watched_store import config_of


async def test_an_order_from_a_vertex_on_the_map() -> None:
    async with planted() as it:
        await it.press("n", "n", "enter")
        await it.shows("Order")
        start = it.app.main.query_one("#from", Input).value
        await it.type("Consum")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, start, "Consumidores")]


async def test_with_cargo_a_vertex_on_the_map_is_where_it_goes() -> None:
    async with planted() as it:
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("n", "n", "enter")
        await it.shows("Destination of the cargo")
        end = it.app.main.query_one("#to", Input).value
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, end)]


async def test_another_robot_in_the_form_means_other_ids() -> None:
    """A choice for one robot is not sent to another: each has a graph of its own."""
    async with planted(2, 2) as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter", "shift+tab", "shift+tab", "end", "backspace", "1", "tab", "tab")
        await it.type("Store")
        await it.press("enter")
        await it.shows("From: Enter takes the marked place")
        assert it.sent == []


async def test_a_vertex_that_the_robot_does_not_know_opens_no_form() -> None:
    config = config_of(SITE, 2, 2)
    first, second = config.robots
    only_below = msgspec.structs.replace(first, floors=["floor_0"])
    async with planted(config=msgspec.structs.replace(config, robots=[only_below, second])) as it:
        await it.press("}", "n", "n", "enter")
        await it.shows("has no vertex")
        assert not it.app.main.query_one(OrderForm).is_open


async def test_an_order_is_given_again_by_an_arrow_and_two_enters() -> None:
    async with planted(2, 2) as it:
        await place(it)
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        it.sent.clear()
        await it.press("1", "o")
        await it.shows("Base -> Consumidores  (last)", "matches")
        await it.press("down")
        await it.shows(" m, about ")
        await it.press("enter")
        await it.shows("Enter  send")
        assert it.app.main.query_one("#to", Input).value == "Consumidores"
        assert it.sent == []
        await it.press("enter")
        assert it.sent == [order(it, "Base", "Consumidores", robot="robot_1")]


async def test_favourites_leave_when_a_label_is_typed() -> None:
    async with planted() as it:
        await place(it)
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        await it.press("o")
        await it.shows("(last)", "matches")
        await it.type("Ba")
        await it.hides("(last)", "matches")


def site(kind: Kind | None = None) -> FleetState:
    """A robot that stands at Base, and knows two floors; both have a Dock."""
    state = fleet(1, 2) if kind is None else of_kinds(fleet(1, 2), kind)
    plain = graph(1, 2, 3).graph
    roles = {"1": Role.PLAIN, "2": Role.DOCKING, "3": Role.ELEVATOR}
    vertices = {id_: replace(one, role=roles[id_]) for id_, one in plain.vertices.items()}
    drawn = GraphReceived(R0, "floor_0", RouteGraph(vertices, plain.edges))
    below = drawn, labels({1: "Base", 2: "Dock", 3: "Lift"})
    above = graph(7, 8, floor="floor_1"), labels({7: "Dock", 8: "Kitchen"}, floor="floor_1")
    return reduced(state, link_up(T0 - 9), pose(T0 - 5), pose(T0), *below, *above, tick(T0))


def shown(state: FleetState, typed: str) -> list[str]:
    robot = state.robots[R0]
    return lines(state, robot, typed, choices(state, robot, "to", typed))


def test_a_place_has_its_kind_and_distance_or_its_floor_and_an_id_only_if_its_label_is_no_name() -> None:
    state = site()
    assert shown(state, "") == [
        "Base      0 m away",
        "Dock (2)  charger, 1 m away",
        "Lift      2 m away",
        "Dock (7)  floor_1",
        "Kitchen   floor_1",
    ]
    assert shown(state, "8") == ["Kitchen (8)  floor_1"], "an id that was typed is told"
    driving = reduced(state, pose(T0 + 1, 0.5), tick(T0 + 1))
    assert shown(driving, "Base") == ["Base"], "a distance would be old at once"


def test_a_destination_has_its_distance_from_the_start_of_the_order_also_while_the_robot_drives() -> None:
    state = reduced(site(), pose(T0 + 1, 0.5), tick(T0 + 1))
    robot = state.robots[R0]
    found = choices(state, robot, "to", "")
    (start,) = [one for one in found if isinstance(one, Place) and one.name == "Lift"]
    assert lines(state, robot, "", found, start)[:4] == [
        "Base      2 m from Lift",
        "Dock (2)  charger, 1 m from Lift",
        "Lift",
        "Dock (7)  floor_1",
    ]


def test_the_form_tells_which_places_are_listed_before_anything_is_typed() -> None:
    state, stays = site(), site(Kind("stays", ("pose", "graph"), (ORDER,), changes_floors=False))
    told = [scope(one.robots[R0], "", choices(one, one.robots[R0], "to", "")) for one in (state, stays)]
    assert told == ["3 on floor_0, then 2 elsewhere", "3 of 5, all on floor_0: type for others"]
    assert scope(state.robots[R0], "Ba", choices(state, state.robots[R0], "to", "Ba")) == ""
    typed = choices(stays, stays.robots[R0], "to", "kitchen")
    assert [one.name for one in typed if isinstance(one, Place)] == ["Kitchen"]
    many = reduced(fleet(), graph(*range(50)), labels({n: f"P{n}" for n in range(50)}), pose(T0), tick(T0))
    found = choices(many, many.robots[R0], "to", "")
    assert scope(many.robots[R0], "", found) == "30 of 50, all on floor_0: type for others"


def test_a_charger_at_which_an_order_makes_a_vehicle_charge_says_so() -> None:
    state = reduced(fleet(), GraphReceived(R0, F0, RouteGraph({"9": Vertex("9", 1.0, 1.0, Role.DOCKING)})))
    robot, dock = state.robots[R0], Place("9", "Dock 9", F0)
    assert lines(state, robot, "", [dock]) == ["Dock 9  charger, floor_0"]
    charges = replace(robot, features=VehicleFeatures(at_nodes=("startCharging",)))
    assert lines(state, charges, "", [dock]) == ["Dock 9  charger, charges there, floor_0"]


def low(*more: Event, kind: Kind | None = None) -> FleetState:
    """A robot 1 m from the Dock, nearly flat."""
    return reduced(site(kind), battery(T0, 8.9), *more, tick(T0 + 1))


def test_a_low_battery_is_told_in_the_words_of_its_alarm_and_a_charger_leads_the_places() -> None:
    state = low()
    assert condition(state, state.robots[R0]) == "battery 8 %" == state.alarms[0].text
    assert shown(state, "")[0] == "Dock (2)  charge, charger, 1 m away"
    robot = state.robots[R0]
    first, *_ = choices(state, robot, "from", "")
    assert isinstance(first, Favourite) and lines(state, robot, "", [first]) == ["Base -> Dock  (charge)"]
    assert shown(state, "Ba") == ["Base  0 m away"], "who types wants something else"


def test_a_robot_that_charges_or_drives_there_is_sent_to_no_charger() -> None:
    for state in (low(pose(T0 + 0.5, 1.0)), low(queue(T0, (1, 1, 2, "W"), current=1))):
        assert charge_first(state, state.robots[R0]) == ()
        assert not any("charge," in line for line in shown(state, ""))


def test_the_condition_is_what_the_row_tells_and_the_note_repeats_none_of_it() -> None:
    state = reduced(site(), PausedReported(R0, T0, True), ObstacleReported(R0, T0, 14.0), tick(T0))
    robot = state.robots[R0]
    row = [text for text, _ in news(state, robot)]
    assert condition(state, robot) == ", ".join(row) == "obstacle 14 s, paused (elsewhere)"
    own = Problem("no path", Message("no path there"))
    assert warnings(state, robot, [own, *robot_problems(state, robot)]) == "no path there"
    well = site()
    assert condition(well, well.robots[R0]) == ""


def test_places_are_listed_by_distance_after_the_last_destinations() -> None:
    state = reduced(site(), pose(T0 - 3, 1.9), pose(T0, 1.9), tick(T0))
    assert [one.split()[0] for one in shown(state, "")] == ["Lift", "Dock", "Base", "Dock", "Kitchen"]
    again = reduced(state, queue(T0, (1, 1, 1, "W")))
    assert shown(again, "")[0].startswith("Base")
