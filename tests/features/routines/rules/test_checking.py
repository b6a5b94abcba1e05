"""Checks of a whole routine: every problem at once, each with its line and remedy."""

from collections.abc import Sequence

import pytest

from fleet_tui.features.routines.rules.checking import check_routine, robots_of
from fleet_tui.features.routines.rules.parsing import parse_routine
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import ORDER_TO, Kind
from tests.support.fleets import R0, fleet, graph, labels, of_kinds, reduced
from tests.support.routines import MORNING, two_robots


def found_in(*lines: str, state: FleetState | None = None, robots: str = R0) -> list[str]:
    parsed = parse_routine("\n".join([f"for {robots}", *lines, "end"]))
    assert parsed.problems == ()

    def program(arguments: Sequence[str]) -> str:
        return f"{arguments[0]}: not found" if arguments[0] == "absent" else ""

    return [
        f"{problem.line}: {problem.text}"
        for problem in check_routine(state or two_robots(), parsed.routine, program)
    ]


def test_a_good_routine_has_no_problem() -> None:
    assert check_routine(two_robots(), parse_routine(MORNING).routine, lambda _: "") == []
    assert robots_of(two_robots(), parse_routine(MORNING).routine) == [R0, "robot_1"]


@pytest.mark.parametrize(
    ("lines", "problem"),
    [
        (("go Bas",), "2: robot_0 has no place 'Bas', did you mean Base?"),
        (("carry Base Base",), "2: From and To are the same place: Base"),
        (("go Base", "go id=9"), "3: robot_0 has no vertex 9"),
        (("go id=9",), "2: robot_0 has no vertex 9"),
        (("run absent --now",), "2: absent: not found"),
        (("wait until at Nowhere",), "2: robot_0 has no place 'Nowhere'"),
        (("repeat", "run x", "end"), "2: endless repeat without a wait or an order in each round"),
        (("repeat", "if idle", "go Base", "end", "end"), "2: endless repeat without a wait or an order"),
        (("repeat 10000", "repeat 10000", "end", "end"), "3: repeat without an instruction: add one"),
        ((), "1: robot_0 has no instruction: add one before end"),
        (("go Base", "on failure", "go Bas", "end"), "4: robot_0 has no place 'Bas'"),
    ],
)
def test_problems(lines: tuple[str, ...], problem: str) -> None:
    found = found_in(*lines)
    assert len(found) == 1 and found[0].startswith(problem)


def test_an_endless_repeat_may_have_a_wait_in_both_parts() -> None:
    assert found_in("repeat", "if idle", "wait 30 s", "else", "go Base", "end", "end") == []


def test_robots_that_do_not_exist_and_robots_with_two_lanes() -> None:
    found = found_in("go Base", robots="robot_0 robt_1 robot_0")
    assert found[0] == "1: unknown robot 'robt_1', did you mean robot_1?"
    assert found[1] == "1: robot_0 has a lane from line 1: put all its instructions there"


def test_places_that_cannot_be_reached_from_the_one_before() -> None:
    apart = graph(1, 2)
    far = graph(8, 9)
    both = reduced(fleet(), apart, labels({1: "Base", 2: "Out", 8: "Island"}))
    joined = {**apart.graph.vertices, **far.graph.vertices}
    whole = type(apart.graph)(joined, (*apart.graph.edges, *far.graph.edges))
    state = reduced(both, type(apart)(R0, "floor_0", whole))
    assert found_in("go Base", "go Island", state=state) == ["3: no path for robot_0 from Base to Island"]
    assert found_in("carry Base Island", state=state) == ["2: no path for robot_0 from Base to Island"]
    lines = ("if idle", "go Base", "else", "go Island", "end", "go Out")
    assert found_in(*lines, state=state) == [], "which part was carried out is not known"


def test_a_graph_that_has_not_arrived_is_a_problem() -> None:
    (found,) = found_in("go Base", state=fleet())
    assert found == "2: robot_0 has no place 'Base': no graph of floor_0"


def test_what_a_kind_does_not_report_or_accept() -> None:
    state = of_kinds(two_robots(), Kind("made up"), Kind("other", accepts=(ORDER_TO,), reports=("queue",)))
    found = found_in("go Base", "wait until idle", "wait until battery > 5", state=state)
    assert [one.partition(":")[2] for one in found] == [
        " robot_0: this kind has no orders",
        " robot_0: this kind does not report its orders: use wait 30 s",
        " robot_0: this kind does not report its battery: use wait 30 min",
    ]
    assert found_in("go Base", "wait until idle", state=state, robots="robot_1") == []
