"""The doctor's judgement of graphs: parts that hang together, and labels."""

from hypothesis import example, given
from hypothesis import strategies as st

from fleet_tui.config.entries import FloorEntry
from fleet_tui.features.doctor.floors import connection_finding, label_finding
from fleet_tui.features.doctor.surveys import FloorSurvey
from fleet_tui.links.discovery.finding import Verdict
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex

FLOOR = FloorEntry("floor_0")


IDS = st.integers(0, 7)


def graph(pairs: list[tuple[int, int]], directed: bool = False, lifts: tuple[int, ...] = ()) -> RouteGraph:
    roles = {id_: Role.ELEVATOR if id_ in lifts else Role.PLAIN for id_ in range(8)}
    vertices = {str(id_): Vertex(str(id_), float(id_), 0.0, role) for id_, role in roles.items()}
    return RouteGraph(
        vertices, tuple(Edge(str(n), *map(str, pair)) for n, pair in enumerate(pairs)), directed
    )


@given(st.lists(st.tuples(IDS, IDS), max_size=20), st.booleans())
@example([(n, n + 1) for n in range(7)], True)
@example([(n, n + 1) for n in range(7)], False)
def test_a_graph_hangs_together_if_there_is_a_path_between_any_two(
    pairs: list[tuple[int, int]], directed: bool
) -> None:
    routes = graph(pairs, directed)
    together = all(routes.path(str(start), str(end)) for start in range(8) for end in range(8))
    found = connection_finding(FLOOR, "", FloorSurvey(routes), routes, False)
    assert (found.verdict is Verdict.OK) == together


def test_elevators_join_parts_where_there_are_other_floors() -> None:
    routes = graph([(0, 1), (1, 2), (2, 3), (4, 5), (5, 6), (6, 7)], lifts=(3, 4))
    assert connection_finding(FLOOR, "", FloorSurvey(routes), routes, True).verdict is Verdict.OK
    alone = connection_finding(FLOOR, "", FloorSurvey(routes, {"6": "Store"}), routes, False)
    assert alone.verdict is Verdict.FAIL and "4 of 8 vertices unreachable" in alone.measured


def test_labels_given_twice_or_not_at_all() -> None:
    routes = graph([])
    assert "duplicate: Base" in label_finding(FLOOR, "", {"0": "Base", "1": "Base"}, routes).measured
    assert label_finding(FLOOR, "", {}, routes).verdict is Verdict.WARN
