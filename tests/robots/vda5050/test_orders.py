"""What leaves for a vehicle."""

from typing import Any

import pytest

from fleet_tui.commands.checks import problems
from fleet_tui.commands.language.grammar import parse
from fleet_tui.config.load import from_text
from fleet_tui.model import events
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.order import Stop, at_vertices
from fleet_tui.model.problem import Permissions, Problem
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import StartCharging
from fleet_tui.robots.adapter import Publication, Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.vda5050.adapter import VehicleAdapter
from fleet_tui.text.errors import CommandError
from tests.support.vda_fleet import VehicleSite, config_text
from tests.support.vda_messages import message, node, position, state, state_3

UNIQUE = "0123456789abcdef0123456789abcdef"
PLACES = {"n0": (1.0, 2.0), "n1": (5.0, 2.0), "n2": (5.0, 6.0), "far": (50.0, 50.0)}
GRAPH = RouteGraph(
    {id_: Vertex(id_, *place) for id_, place in PLACES.items()},
    (Edge("a", "n0", "n1"), Edge("b", "n1", "n2")),
)


def site(settings: str = "", **fields: Any) -> VehicleSite:
    found = VehicleSite(from_text(config_text(settings=settings)))
    found.apply(events.FloorGraphLoaded("hall", GRAPH))
    found.read("state", state(**fields))
    return found


def sent(found: VehicleSite, command: Command) -> Publication:
    (one,) = found.adapter.outgoing(command, 1, found.agv, UNIQUE)
    assert isinstance(one, Publication)
    return one


def nodes(one: Publication) -> list[Any]:
    found = one.message["nodes"]
    assert isinstance(found, list)
    return found


def test_an_order_leads_over_the_graph_from_the_last_node() -> None:
    found = site()
    one = sent(found, PlaceOrder("agv", at_vertices("n2")))
    assert one.address == "uagv/v2/KIT/0001/order" and one.type == "2.0.0"
    assert one.message["manufacturer"] == "KIT" and one.message["serialNumber"] == "0001"
    assert one.message["orderId"] == one.name and one.message["orderUpdateId"] == 0
    assert one.name.endswith(found.adapter.site.console)
    assert [(part["nodeId"], part["sequenceId"]) for part in nodes(one)] == [("n0", 0), ("n1", 2), ("n2", 4)]
    assert all(part["released"] and part["actions"] == [] for part in nodes(one))
    assert nodes(one)[2]["nodePosition"] == {"x": 5.0, "y": 6.0, "mapId": "hall"}
    edges: Any = one.message["edges"]
    assert [(e["sequenceId"], e["startNodeId"], e["endNodeId"]) for e in edges] == [
        (1, "n0", "n1"),
        (3, "n1", "n2"),
    ]


def test_from_one_place_to_another_is_one_order() -> None:
    one = sent(site(), PlaceOrder("agv", at_vertices("n1", "n0")))
    assert [part["nodeId"] for part in nodes(one)] == ["n0", "n1", "n0"]


def test_a_free_vehicle_begins_where_it_stands() -> None:
    one = sent(
        site(agvPosition=position(2.0, 8.0), lastNodeId=""), PlaceOrder("agv", (Stop(pose=Pose(3, 3)),))
    )
    assert [part["nodeId"] for part in nodes(one)] == ["here", "goal_0"]
    assert nodes(one)[0]["nodePosition"] == {"x": 2.0, "y": 8.0, "mapId": "hall"}
    one = sent(site(agvPosition=position(2.0, 8.0), lastNodeId=""), PlaceOrder("agv", at_vertices("n2")))
    assert [part["nodeId"] for part in nodes(one)] == ["here", "n2"]


def test_a_line_guided_vehicle_begins_at_its_last_node() -> None:
    one = sent(site(agvPosition=None), PlaceOrder("agv", at_vertices("n1")))
    assert [part["nodeId"] for part in nodes(one)] == ["n0", "n1"]


@pytest.mark.parametrize(
    ("vertex", "reason"),
    [("far", "no path from n0 to far on the graph"), ("gone", "position of node gone unknown")],
)
def test_a_place_without_a_way_is_refused(vertex: str, reason: str) -> None:
    with pytest.raises(CommandError, match=reason):
        sent(site(), PlaceOrder("agv", at_vertices(vertex)))


def test_a_vehicle_without_any_place_is_refused() -> None:
    with pytest.raises(CommandError, match="neither a pose nor a node"):
        sent(site(agvPosition=None, lastNodeId=""), PlaceOrder("agv", at_vertices("n1")))


def test_a_site_adds_its_deviation_and_its_actions() -> None:
    settings = 'deviation = 0.2\nactions.pick = { actionType = "pick", blockingType = "SOFT" }'
    one = sent(site(settings), PlaceOrder("agv", at_vertices("n1", "n2")))
    assert nodes(one)[1]["nodePosition"]["allowedDeviationXY"] == 0.2
    assert nodes(one)[1]["actions"] == [
        {"actionId": f"{one.name}-pick", "actionType": "pick", "blockingType": "SOFT", "actionParameters": []}
    ]
    assert nodes(one)[2]["actions"] == []


@pytest.mark.parametrize(
    ("command", "type_"),
    [
        (PauseRobot("agv"), "startPause"),
        (ResumeRobot("agv"), "stopPause"),
        (ClearOrders("agv"), "cancelOrder"),
        (StartCharging("agv"), "startCharging"),
    ],
)
def test_instant_actions_are_one_a_message(command: Command, type_: str) -> None:
    one = sent(site(), command)
    assert one.address == "uagv/v2/KIT/0001/instantActions"
    usual = {"actionType": type_, "actionId": one.name, "blockingType": "NONE", "actionParameters": []}
    assert one.message["actions"] == [usual]


def test_the_field_of_instant_actions_is_that_of_the_version_or_of_the_site() -> None:
    assert "instantActions" in sent(site(version="1.1.0"), PauseRobot("agv")).message
    assert "instantActions" in sent(site('instant_actions = "instantActions"'), PauseRobot("agv")).message


def test_only_the_order_that_is_driven_can_be_cancelled() -> None:
    found = site(orderId="o1", nodeStates=[node("n1", 2)])
    assert sent(found, CancelOrder("agv", "o1")).message["actions"]
    with pytest.raises(CommandError, match="unknown order o2: see the queue of agv"):
        sent(found, CancelOrder("agv", "o2"))


@pytest.mark.parametrize("command", [PauseRobot("agv"), ResumeRobot("agv")])
def test_a_vehicle_of_version_3_is_paused_and_resumed_but_takes_no_orders(command: Command) -> None:
    found = VehicleSite()
    found.read("state", state_3(), base="vda5050/v3/KIT/0001")
    one = sent(found, command)
    assert one.address == "vda5050/v3/KIT/0001/instantActions" and one.type == "3.0.0"
    assert list(one.message) == ["manufacturer", "serialNumber", "actions"]
    with pytest.raises(
        CommandError, match=r"speaks VDA 5050 3\.0\.0: orders in that version are not supported"
    ):
        sent(found, PlaceOrder("agv", at_vertices("n1")))


def test_a_vehicle_that_was_never_seen_is_only_paused_where_the_configuration_has_its_topic() -> None:
    found = VehicleSite()
    both = found.adapter.outgoing(PauseRobot("agv"), 1, found.agv, UNIQUE)
    told = [(one.address, sorted(one.message)) for one in both if isinstance(one, Publication)]
    assert told == [
        ("vda5050/v3/KIT/0001/instantActions", ["actions", "manufacturer", "serialNumber"]),
        ("uagv/v2/KIT/0001/instantActions", ["actions", "manufacturer", "serialNumber"]),
        ("uagv/v1/KIT/0001/instantActions", ["instantActions", "manufacturer", "serialNumber"]),
    ]
    for command in (ResumeRobot("agv"), ClearOrders("agv"), PlaceOrder("agv", ())):
        with pytest.raises(CommandError):
            found.adapter.outgoing(command, 1, found.agv, UNIQUE)
    of_any = Profile(kind="vda5050")
    with pytest.raises(CommandError, match="never seen"):
        VehicleAdapter(of_any, Site(role="pause")).outgoing(PauseRobot("agv"), 1, found.agv, UNIQUE)


@pytest.mark.parametrize("version", ["v1.1", "V1.1.0", "1.1"])
def test_a_version_is_read_as_it_is_meant(version: str) -> None:
    assert "instantActions" in sent(site(version=version), PauseRobot("agv")).message
    newer = version.replace("1.1", "2.1")
    assert "actions" in sent(site(version=newer), PauseRobot("agv")).message


SHEET = {"parameter": "order.nodes.nodePosition.allowedDeviationXY", "support": "SUPPORTED"}
THETA = {"parameter": "order.nodes.nodePosition.theta", "support": "REQUIRED"}
TURNED = PlaceOrder("agv", (Stop(pose=Pose(5.0, 2.0, 1.5)),))


@pytest.mark.parametrize("parameters", [None, [], [SHEET, THETA]])
def test_a_goal_keeps_the_heading_that_was_given(parameters: list[dict[str, str]] | None) -> None:
    found = site()
    if parameters is not None:
        found.read("factsheet", message(protocolFeatures={"optionalParameters": parameters}))
    assert nodes(sent(found, TURNED))[-1]["nodePosition"]["theta"] == 1.5
    free = PlaceOrder("agv", (Stop(pose=Pose(5.0, 2.0), turns_freely=True),))
    assert "theta" not in nodes(sent(found, free))[-1]["nodePosition"]


def test_where_the_factsheet_forbids_a_heading_that_is_said_before_the_order_is_sent() -> None:
    found = site()
    found.read("factsheet", message(protocolFeatures={"optionalParameters": [SHEET]}))
    found.wait(0.1)

    def headings(request: Request) -> list[Problem]:
        return [one for one in problems(found.state, request, Permissions()) if one.check == "no heading"]

    (problem,) = headings(Request((TURNED,)))
    assert problem.text == "agv accepts no heading (factsheet): it chooses its own at the goal"
    assert not problem.blocks and "theta" not in nodes(sent(found, TURNED))[-1]["nodePosition"]
    assert headings(parse("goto agv 5 2", found.state)) == []


def test_a_typed_heading_is_one() -> None:
    found = site()
    (turned,) = parse("goto agv 5 2 90", found.state).commands
    assert nodes(sent(found, turned))[-1]["nodePosition"]["theta"] == pytest.approx(1.5708, abs=1e-4)


CHARGERS = RouteGraph({**GRAPH.vertices, "n2": Vertex("n2", 5.0, 6.0, Role.DOCKING)}, GRAPH.edges)


def charging(*scopes: str) -> bytes:
    actions = [{"actionType": f"{verb}Charging", "actionScopes": list(scopes)} for verb in ("start", "stop")]
    return message(protocolFeatures={"agvActions": actions})


@pytest.mark.parametrize(("scopes", "types"), [(("NODE", "INSTANT"), ["startCharging"]), (("INSTANT",), [])])
def test_an_order_to_a_charger_charges_there_if_the_factsheet_offers_that(
    scopes: tuple[str, ...], types: list[str]
) -> None:
    found = site()
    found.apply(events.FloorGraphLoaded("hall", CHARGERS))
    found.read("factsheet", charging(*scopes))
    (_, middle, last) = nodes(sent(found, PlaceOrder("agv", at_vertices("n2"))))
    assert [action["actionType"] for action in last["actions"]] == types and middle["actions"] == []
    elsewhere = nodes(sent(found, PlaceOrder("agv", at_vertices("n1"))))
    assert all(part["actions"] == [] for part in elsewhere)


@pytest.mark.parametrize(
    ("is_charging", "scopes", "types"),
    [
        (True, ["NODE"], ["stopCharging"]),
        (False, ["NODE"], []),
        (True, ["INSTANT"], []),
        (True, ["EDGE"], []),
    ],
)
def test_one_that_charges_ends_that_at_the_first_node_where_its_factsheet_offers_it_there(
    is_charging: bool, scopes: list[str], types: list[str]
) -> None:
    found = site()
    found.apply(events.FloorGraphLoaded("hall", CHARGERS))
    found.read("factsheet", charging(*scopes))
    found.read("state", state(batteryState={"batteryCharge": 50.0, "charging": is_charging}))
    first, *others = nodes(sent(found, PlaceOrder("agv", at_vertices("n1"))))
    assert [action["actionType"] for action in first["actions"]] == types
    assert all(action["blockingType"] == "HARD" for action in first["actions"])
    assert all(one["actions"] == [] for one in others)


def test_without_a_factsheet_it_only_drives_there() -> None:
    found = site()
    found.apply(events.FloorGraphLoaded("hall", CHARGERS))
    assert all(part["actions"] == [] for part in nodes(sent(found, PlaceOrder("agv", at_vertices("n2")))))


def test_a_vehicle_whose_factsheet_lists_no_request_of_its_state_is_not_asked() -> None:
    found = site()
    (asked,) = found.adapter.state_request(found.agv, UNIQUE)
    (action,) = list(asked.message["actions"])  # type: ignore[call-overload]  # of a list
    assert action["actionType"] == "stateRequest"
    found.read("factsheet", charging("INSTANT"))
    assert found.adapter.state_request(found.agv, UNIQUE) == ()


def test_a_vehicle_that_charges_is_freed_if_its_factsheet_offers_that() -> None:
    found = site()
    found.read("factsheet", charging("INSTANT"))
    assert found.adapter.stop_charging(found.agv, UNIQUE) is None, "it does not charge"
    found.read("state", state(batteryState={"batteryCharge": 50.0, "charging": True}))
    asked = found.adapter.stop_charging(found.agv, UNIQUE)
    assert asked is not None
    (action,) = list(asked.message["actions"])  # type: ignore[call-overload]  # of a list
    assert action["actionType"] == "stopCharging"
    found.read("factsheet", charging("NODE"))
    assert found.adapter.stop_charging(found.agv, UNIQUE) is None


def test_an_order_whose_last_action_is_the_charging_begins_that_once() -> None:
    found = site('actions.drop = { actionType = "startCharging" }')
    found.apply(events.FloorGraphLoaded("hall", CHARGERS))
    found.read("factsheet", charging("NODE"))
    last = nodes(sent(found, PlaceOrder("agv", at_vertices("n1", "n2"))))[-1]
    assert [action["actionType"] for action in last["actions"]] == ["startCharging"]
