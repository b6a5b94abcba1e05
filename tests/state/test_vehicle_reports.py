"""Who is online, and what an order adds to the graph."""

from fleet_tui.cli.status.report import attention
from fleet_tui.model import events
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.vehicles.events import FactsheetReported
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import message, node, state

BROKEN, ONLINE = message(connectionState="CONNECTIONBROKEN"), message(connectionState="ONLINE")
OLD_BASE = "uagv/v1/KIT/0001"


def test_any_newer_message_wins_over_a_last_will() -> None:
    site = VehicleSite()
    site.read("state", state())
    site.wait(1)
    site.read("connection", BROKEN)
    assert not site.state.is_online(site.agv)
    site.wait(1)
    site.read("state", state())
    assert site.state.is_online(site.agv)


def test_an_action_is_carried_out_until_a_report_without_it() -> None:
    site = VehicleSite()
    site.read("state", state(actionStates=[{"actionId": "a", "actionStatus": "RUNNING"}]))
    assert site.agv.acting is not None and site.agv.acting.action.id == "a"
    site.read("state", state(actionStates=[{"actionId": "a", "actionStatus": "FINISHED"}]))
    assert site.agv.acting is None


def test_a_kept_last_will_is_older_than_everything() -> None:
    site = VehicleSite()
    site.read("connection", BROKEN, kept=True)
    assert site.agv.connection is not None and not site.state.is_online(site.agv)
    site.read("state", state())
    assert site.state.is_online(site.agv)


def test_after_our_own_loss_a_kept_last_will_counts_until_the_next_state() -> None:
    site = VehicleSite()
    site.read("state", state())
    site.wait(5)
    site.read("connection", BROKEN, kept=True)
    assert not site.state.is_online(site.agv)
    site.read("state", state())
    assert site.state.is_online(site.agv)


def test_a_kept_goodbye_on_topics_of_an_older_version_tells_nothing() -> None:
    site = VehicleSite()
    site.read("state", state())
    site.wait(1)
    site.read("connection", message(connectionState="OFFLINE"), kept=True, base=OLD_BASE)
    assert site.state.is_online(site.agv)


def test_an_emptied_kept_message_is_a_vehicle_removed_and_no_bad_data() -> None:
    site = VehicleSite()
    site.read("connection", BROKEN, kept=True)
    for name in ("connection", "state", "factsheet"):
        site.read(name, b"")
    (line,) = attention(site.state)
    assert line == "agv: offline (removed from the broker)" and site.agv.faults == 0
    site.read("state", state())
    assert site.state.is_online(site.agv)


def test_a_vehicle_that_is_there_stays_so_when_its_connection_message_is_removed() -> None:
    site = VehicleSite()
    site.read("connection", ONLINE)
    site.read("state", state())
    site.read("connection", b"")
    assert site.state.is_online(site.agv) and site.agv.connection is None


def test_a_vehicle_is_offline_after_35_seconds_of_silence() -> None:
    site = VehicleSite()
    site.read("connection", ONLINE)
    site.read("state", state())
    site.wait(34)
    assert site.state.is_online(site.agv)
    site.wait(2)
    assert not site.state.is_online(site.agv)


def test_a_violated_field_is_counted_from_its_first_report() -> None:
    site = VehicleSite()
    violated = {"eStop": "NONE", "fieldViolation": True}
    site.read("state", state(safetyState=violated))
    site.wait(4)
    site.read("state", state(safetyState=violated))
    assert site.agv.blocked is not None and site.agv.blocked.value.since == site.now - 4
    site.read("state", state())
    assert not site.agv.blocked.value.is_stopped or site.agv.blocked.value.action == ""


def test_nodes_of_an_order_fill_the_gaps_of_a_graph() -> None:
    site = VehicleSite()
    known = RouteGraph({"a": Vertex("a", 0.0, 0.0), "b": Vertex("b", 1.0, 0.0)}, (Edge("e", "a", "b"),))
    site.apply(events.FloorGraphLoaded("hall", known, {"a": "Alpha"}))
    site.read("state", state())
    nodes = [node("a", 0, x=9.0), node("b", 2, x=9.0), node("x", 4, x=3.0)]
    site.read("state", state(orderId="o", nodeStates=nodes))
    graph = site.agv.maps["hall"].graph
    assert graph is not None and list(graph.vertices) == ["a", "b", "x"]
    assert graph.vertices["a"].x == 0.0 and graph.path("a", "x") == ("a", "b", "x")
    assert site.agv.name_of("a") == "Alpha" and site.agv.name_of("x") == "x"
    site.read("state", state(orderId="o2", nodeStates=[node("y", 0, x=7.0)]))
    graph = site.agv.maps["hall"].graph
    assert graph is not None and list(graph.vertices) == ["a", "b", "y"]


def test_nodes_on_another_map_are_not_drawn_on_this_one() -> None:
    site = VehicleSite()
    site.read("state", state())
    far = {"nodeId": "z", "sequenceId": 0, "nodePosition": {"x": 0, "y": 0, "mapId": "attic"}}
    site.read("state", state(nodeStates=[far]))
    assert site.agv.maps["hall"].graph is None


def test_properties_and_masters_are_kept() -> None:
    site = VehicleSite()
    site.apply(FactsheetReported("agv", site.now, {"speedMax": "2"}))
    assert site.agv.factsheet == {"speedMax": "2"}
    site.read("order", message(orderId="o", nodes=[], edges=[]))
    assert site.agv.master is not None and site.agv.master.value == "order o"


def test_a_vehicle_without_a_position_is_drawn_at_its_last_node() -> None:
    site = VehicleSite()
    site.apply(events.FloorGraphLoaded("hall", RouteGraph({"n0": Vertex("n0", 3.0, 4.0)})))
    site.read("state", state(agvPosition=None))
    assert site.agv.pose is not None and (site.agv.pose.value.x, site.agv.pose.value.y) == (3.0, 4.0)
    assert site.agv.floor == "hall"
    site.read("state", state(agvPosition=None, lastNodeId="unknown"))
    assert site.agv.pose.value.x == 3.0
    site.read("state", state())
    assert site.agv.pose is not None and site.agv.pose.value.x == 1.0
