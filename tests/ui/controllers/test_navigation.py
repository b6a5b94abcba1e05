"""The robot and the floor that is looked at: chosen by step, by number and by name."""

from fleet_tui.model.attention import Attention, SeenArea
from fleet_tui.model.events import PoseReported
from fleet_tui.model.geometry import Pose
from tests.support.desk import Desk
from tests.support.fleets import T0, fleet, reduced


def desk() -> Desk:
    """Three robots on two floors, of which the second one is on the second floor."""
    return Desk(reduced(fleet(3, 2), PoseReported("robot_1", T0, Pose(1.0, 2.0), "floor_1", None)))


def test_steps_go_round() -> None:
    it = desk()
    it.navigation.step_robot(-1)
    it.navigation.step_robot(1)
    assert it.selected == ["robot_2", "robot_0"]
    assert it.navigation.robot == "robot_0" and it.camera.centred == []
    assert it.camera.revealed == 2


def test_finding_a_robot_shows_its_floor_and_brings_the_map_to_it() -> None:
    it = desk()
    it.navigation.find_robot("robot_1")
    assert (it.navigation.robot, it.navigation.floor, it.camera.centred) == ("robot_1", "floor_1", [None])


def test_a_floor_that_was_chosen_stays_until_a_robot_of_another_one_is_selected() -> None:
    it = desk()
    it.navigation.step_floor(1)
    assert it.navigation.settle(it.store.state, follow=False).floor == "floor_1"
    it.navigation.step_floor(1)
    it.navigation.select("robot_1")
    assert it.navigation.settle(it.store.state, follow=False).floor == "floor_1"


def test_a_vertex_is_found_with_its_floor() -> None:
    it = desk()
    it.navigation.find_vertex("floor_1", 3.0, 4.0)
    assert (it.navigation.floor, it.camera.centred) == ("floor_1", [(3.0, 4.0)])


def test_a_chosen_floor_or_place_ends_following_and_the_floor_that_is_shown_does_not() -> None:
    it = desk()
    it.camera.follows = True
    it.navigation.find_floor("floor_0")
    assert it.camera.follows
    it.navigation.step_floor(1)
    assert not it.camera.follows
    it.camera.follows = True
    it.navigation.find_vertex("floor_1", 3.0, 4.0)
    assert not it.camera.follows


def test_what_is_looked_at_is_beside_the_state() -> None:
    it = desk()
    it.camera.area = SeenArea(0.0, 0.0, 9.0, 9.0, 0.5)
    it.navigation.find_robot("robot_1")
    assert it.store.attention == Attention("robot_1", "floor_1", it.camera.area)
