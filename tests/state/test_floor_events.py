"""Files of floors: who gets a graph from a file, and what is said of one that can't be read."""

from msgspec.structs import replace

from fleet_tui.model.events import FloorGraphLoaded
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from tests.support.fleets import F0, fleet, graph, labels, told

FILE = FloorGraphLoaded(F0, graph(1, 2).graph, {"1": "Base"}, "graph g.json: vertex 1 duplicated")


def mute(state: FleetState, *robots: str) -> FleetState:
    """Robots of a kind that publishes no graph."""
    changed = {name: replace(state.robots[name], kind=Kind("mute", ("pose",))) for name in robots}
    return replace(state, robots={**state.robots, **changed})


def test_robots_that_publish_no_graph_share_that_of_the_file() -> None:
    state = told(mute(fleet(3), "robot_0", "robot_2"), FILE)
    maps = [robot.maps[F0] for robot in state.robots.values()]
    assert maps[0].graph is maps[2].graph is FILE.graph
    assert maps[0].labels == {"1": "Base"} and maps[0].name_of("1") == "Base"
    assert maps[0].name_of("2") == "2" and maps[0].name_of("3") is None
    assert maps[1].graph is None and maps[1].labels == {}
    assert state.floors[F0].graph_problem == "graph g.json: vertex 1 duplicated"


def test_a_robots_own_graph_stays() -> None:
    state = told(mute(fleet(2), "robot_1"), graph(7, 8), labels({7: "Own"}), FILE)
    own = state.robots["robot_0"].maps[F0]
    assert own.graph is not None and set(own.graph.vertices) == {"7", "8"} and own.labels == {"7": "Own"}


def test_only_robots_of_the_floor_get_it() -> None:
    state = mute(fleet(2, 2), "robot_0", "robot_1")
    upstairs = state.robots["robot_1"]
    upstairs = replace(upstairs, maps={"floor_1": upstairs.maps["floor_1"]})
    state = told(replace(state, robots={**state.robots, "robot_1": upstairs}), FILE)
    assert state.robots["robot_0"].maps["floor_1"].graph is None
    assert state.robots["robot_1"] is upstairs


def test_a_file_that_cannot_be_read_costs_no_graph_and_is_said() -> None:
    state = told(mute(fleet(), "robot_0"), FILE, FloorGraphLoaded(F0, None, {}, "graph g.json: no such file"))
    assert state.floors[F0].graph_problem == "graph g.json: no such file"
    assert state.robots["robot_0"].maps[F0].graph is FILE.graph
    assert state.floors[F0].problem == ""
