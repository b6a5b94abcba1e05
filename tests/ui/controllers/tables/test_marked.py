"""Commands to all marked robots."""

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import Request
from tests.support.desk import Desk
from tests.support.fleets import LINK, R0, T0, fleet, graph, labels, link_up, pose, queue, reduced, tick

R1, R2 = "robot_1", "robot_2"
ORDER = Request((PlaceOrder(R0, at_vertices("1", "2")),), (("1", "floor_0"), ("2", "floor_0")))


def site() -> FleetState:
    """Three robots; the ids of robot_1 for the labels are others, and robot_2 is offline."""
    alive = events.CommandPathChanged(LINK, CommandPath.ALIVE, connected=True)
    known = [
        fact
        for name, ids in ((R0, (1, 2)), (R1, (11, 12)))
        for fact in (
            graph(*ids, robot=name),
            labels(dict(zip(ids, ("Base", "Store"), strict=True)), robot=name),
            queue(T0, robot=name),
            events.CargoReported(name, T0, False),
            replace(pose(T0), robot=name),
        )
    ]
    return reduced(fleet(3), link_up(T0), alive, *known, tick(T0 + 0.5))


def desk(*marks: str) -> Desk:
    made = Desk(site())
    made.marks += marks
    return made


def test_without_marks_a_command_is_the_selected_robots() -> None:
    it = desk()
    it.marked.do(R0, ResumeRobot)
    assert it.backend.submitted == [ResumeRobot(R0)] and not it.answers and not it.outcomes


def test_a_pause_of_marked_robots_leaves_at_once() -> None:
    it = desk(R0, R1)
    it.marked.do(R2, PauseRobot)
    assert it.backend.submitted == [PauseRobot(R0), PauseRobot(R1)]
    assert not it.answers and not it.marks, "the marks are gone with it"


def test_other_commands_are_asked_once_and_each_has_its_outcome() -> None:
    it = desk(R0, R1)
    it.marked.do(R0, ResumeRobot)
    assert it.backend.submitted == [] and len(it.answers) == 1
    assert R0 in it.asked[0] and R1 in it.asked[0]
    it.say_yes()
    assert it.backend.submitted == [ResumeRobot(R0), ResumeRobot(R1)]
    assert it.outcomes == [(ResumeRobot(R0), ""), (ResumeRobot(R1), "")]


def test_one_that_can_not_is_named_and_holds_up_no_other() -> None:
    it = desk(R0, R2)
    it.marked.do(R0, ClearOrders)
    assert "not sent: " in it.asked[0] and R0 in it.asked[0], "it has no order to clear"
    it.say_yes()
    assert it.backend.submitted == [ClearOrders(R2)]
    assert [bool(problem) for _, problem in it.outcomes] == [True, False]


def test_an_order_goes_to_each_marked_robot_by_the_labels_of_its_own_graph() -> None:
    it, closed = desk(R0, R1), list[bool]()
    assert it.marked.give_order(ORDER, lambda: closed.append(True)) == ""
    assert it.backend.submitted == [] and not closed
    it.say_yes()
    assert it.backend.submitted == [
        PlaceOrder(R0, at_vertices("1", "2")),
        PlaceOrder(R1, at_vertices("11", "12")),
    ]
    assert closed == [True]


def test_an_order_for_another_robot_than_the_marked_ones_is_its_own() -> None:
    it = desk(R1, R2)
    assert it.marked.give_order(ORDER, lambda: None) == ""
    assert it.backend.submitted == [PlaceOrder(R0, at_vertices("1", "2"))] and not it.answers


def test_a_long_question_is_counted_to_its_end() -> None:
    it = desk()
    it.marked.give([Request((CancelOrder(R0, str(n)),)) for n in range(40)])
    assert len(it.asked[0].splitlines()) < 20 and it.asked[0].splitlines()[-1].startswith("and ")


def test_several_orders_of_one_robot_are_counted_as_commands() -> None:
    it = desk()
    it.marked.give([Request((CancelOrder(R0, str(n)),)) for n in range(2)])
    assert it.asked[0].startswith("Send 2 commands?")


def test_the_only_mark_is_gone_with_its_command() -> None:
    it = desk(R1)
    it.marked.do(R0, ResumeRobot)
    assert it.backend.submitted == [ResumeRobot(R1)] and not it.marks
    it = desk(R0)
    assert it.marked.give_order(ORDER, lambda: None) == ""
    assert it.backend.submitted == [PlaceOrder(R0, at_vertices("1", "2"))] and not it.marks


def test_a_robot_without_the_place_gets_no_order_to_another_vertex_of_that_id() -> None:
    it = Desk(reduced(site(), graph(1, 2, robot=R1), labels({1: "Store", 2: "Door"}, robot=R1)))
    it.marks += [R0, R1]
    assert it.marked.give_order(ORDER, lambda: None) == ""
    it.say_yes()
    assert it.backend.submitted == [PlaceOrder(R0, at_vertices("1", "2"))]
    assert it.outcomes[1][1] == "not sent: robot_1 has no Base on floor_0"
