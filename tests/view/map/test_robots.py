"""Robots on the map: chips whose numbers stay at their arrows."""

import re
from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.picture import backdrop, picture
from fleet_tui.view.map.robots import Arrangement
from fleet_tui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.view.roles import StyleRole

CAMERA = Camera.fit((400, 200), 120, 40)
CELL = CAMERA.scale * 2 * 0.05
"""Metres."""
EMPTY = Scene("f", MapFrame(0.05, 400, 200))


def drawn(robots: tuple[SceneRobot, ...], before: Arrangement | None = None, camera: Camera = CAMERA) -> str:
    scene = replace(EMPTY, robots=robots)
    return picture(backdrop(scene, camera, MapOptions()), scene, camera, MapOptions(), before).text()


def roles(*robots: SceneRobot) -> set[int]:
    scene = replace(EMPTY, robots=robots)
    cells = picture(backdrop(scene, CAMERA, MapOptions()), scene, CAMERA, MapOptions())
    return set(cells.roles.ravel().tolist())


def robot(number: int, cell: float, obstacle: bool = False) -> SceneRobot:
    """A robot some cells right of the middle."""
    return SceneRobot(f"r{number}", number, Pose(10.05 + cell * CELL, 5.0), obstacle=obstacle)


def test_the_number_is_left_of_the_arrow_and_right_where_another_robot_is_there() -> None:
    assert "1→ " in drawn((robot(1, 0),))
    assert " 1→ →2 " in drawn((robot(1, 0), robot(2, 2)))


def test_robots_side_by_side_are_one_chip_with_an_arrow_only_where_all_have_it() -> None:
    one, other = robot(1, 0), robot(2, 1)
    assert " 1,2→ " in drawn((one, other))
    turned, loaded = other._replace(pose=Pose(10.05 + CELL, 5.0, 3.14)), other._replace(cargo=True)
    for different, own in ((turned, "←"), (loaded, "▶")):
        assert " 1,2• " in drawn((one, different)), "nobody sees whose arrow it is"
        assert f" 1,2{own} " in drawn((one, different._replace(selected=True))), "the selected one's"


def test_numbers_together_have_no_arrows_of_different_headings() -> None:
    crowd = robot(1, 0), robot(2, 2), robot(3, 4)
    assert " 1,2→ → →3 " in drawn(crowd)
    other = crowd[1]._replace(pose=Pose(10.05 + 2 * CELL, 5.0, 3.14))
    assert " 1,2• • →3 " in drawn((crowd[0], other, crowd[2]))


def test_robots_in_one_cell_are_listed_or_counted() -> None:
    assert " 1,2→ " in drawn((robot(1, 0), robot(2, 0)))
    assert " 2,1,3!→ " in drawn((robot(1, 0), robot(2, 0), robot(3, 0, obstacle=True)))
    assert "3→ 1+2→ →5" in drawn((robot(3, -5), robot(1, 0), robot(2, 0), robot(4, 0), robot(5, 2)))


def test_an_acknowledged_alarm_is_marked_without_red_alone_and_in_a_crowd() -> None:
    red = {StyleRole.ROBOT_ALARM, StyleRole.ROBOT_BODY_ALARM}
    for chosen in (False, True):
        new = robot(1, 0)._replace(alarmed=True, selected=chosen, size=(2.0, 2.0))
        seen = new._replace(alarmed=False, acknowledged=True)
        for others in ((), (robot(2, 0), robot(3, 1), robot(4, 2))):
            assert roles(new, *others) & red == (red - {StyleRole.ROBOT_BODY_ALARM} if chosen else red)
            assert not roles(seen, *others) & red
            assert "1!" in drawn((seen, *others))


def test_an_alarm_that_waits_comes_before_one_that_is_acknowledged() -> None:
    seen, new = robot(1, 0)._replace(acknowledged=True), robot(2, 0)._replace(alarmed=True)
    assert "1!,2!→" in drawn((seen, new)), "the first one's number is at the arrow"


def test_ages_are_told_of_a_robot_alone_but_not_among_several() -> None:
    one, other = (robot(number, 0)._replace(online=False, age=13.0) for number in (8, 10))
    assert "8 (13 s)" in drawn((one,))
    text = drawn((one, other))
    assert "10○,8○→" in text and "(13 s)" not in text
    narrow = replace(CAMERA, width=80)
    assert "8○→" in drawn((one,), camera=narrow)
    assert "8 (13 s)" in drawn((one._replace(selected=True),), camera=narrow)


def test_a_robot_without_space_beside_its_arrow_has_its_number_in_place_of_it() -> None:
    one = robot(7, 0)
    assert drawn((one,), camera=Camera.fit((400, 200), 1, 1)).strip() == "7"
    assert drawn((one._replace(mark="17"),), camera=Camera.fit((400, 200), 1, 1)).strip() == "→"


def test_the_number_of_a_robot_between_others_is_with_a_neighbours_in_the_sequence_of_the_arrows() -> None:
    robots = robot(1, 0), robot(2, 2), robot(3, 4)
    text = drawn(robots)
    assert " 1,2→ → →3 " in text
    # The chip reaches from the numbers to the last arrow that they are of.
    scene = replace(EMPTY, robots=robots)
    roles = picture(backdrop(scene, CAMERA, MapOptions()), scene, CAMERA, MapOptions()).roles
    (y,) = (n for n, line in enumerate(text.split("\n")) if "1,2→ → →3" in line)
    x = text.split("\n")[y].index("1,2→ → →3")
    assert roles[y, x + 4] == StyleRole.ROBOT and roles[y, x + 6] != StyleRole.ROBOT


def test_the_selected_robot_in_a_crowd_has_its_number_above_it() -> None:
    crowd = tuple(robot(number, 2 * number - 12) for number in range(1, 12))
    selected = crowd[5]._replace(selected=True)
    rows = drawn((*crowd[:5], selected, *crowd[6:])).split("\n")
    row = next(n for n, text in enumerate(rows) if "→ → →" in text)
    assert "6" in rows[row - 1] and rows[row][rows[row - 1].index("6")] == "→"


def test_the_age_of_an_old_pose_covers_no_label() -> None:
    old = robot(1, 0)._replace(online=False, age=18.0)
    assert "1 (18 s)→" in drawn((old,))
    labelled = replace(
        EMPTY,
        robots=(old,),
        vertices=tuple(SceneVertex(str(n), 10.05 + n * 4 * CELL, 5.0, label="Receive") for n in (-1, 1)),
    )
    text = picture(backdrop(labelled, CAMERA, MapOptions()), labelled, CAMERA, MapOptions()).text()
    row = next(row for row in text.split("\n") if "→" in row)
    assert row.count("Receive") == 2
    assert "1→" in row or "→1" in row


def test_a_number_stays_on_its_side_while_there_is_space() -> None:
    before = Arrangement()
    assert "→2" in drawn((robot(1, 0), robot(2, 2)), before)
    assert "→2" in drawn((robot(2, 2),), before)
    assert "2→" in drawn((robot(2, 2),))


def test_numbers_stay_on_their_sides_while_robots_drive_past_each_other() -> None:
    before = Arrangement()
    rows = [drawn((robot(1, 0), robot(2, column)), before).split() for column in range(-4, 5)]
    apart, close, together = ["2→", "1→"], ["2→1→"], ["1,2→"]
    assert rows[:3] == [apart, apart, close] and rows[3:6] == [together] * 3
    assert rows[6:] == [["1→2→"], ["1→", "2→"], ["1→", "2→"]]


def test_the_robot_in_trouble_has_its_number_before_the_others() -> None:
    assert "3→ 1,4!→ →5" in drawn((robot(3, -6), robot(1, 0), robot(4, 0, obstacle=True), robot(5, 2)))


@given(st.lists(st.tuples(st.floats(9.0, 11.0), st.floats(4.5, 5.5)), min_size=2, max_size=9))
def test_two_numbers_never_read_as_one(at: list[tuple[float, float]]) -> None:
    robots = tuple(SceneRobot(f"r{n}", n, Pose(*place), mark=str(100 + n)) for n, place in enumerate(at))
    counted = re.sub(r"\+\d+", " ", drawn(robots))
    words = "".join(letter if letter.isdigit() else " " for letter in counted).split()
    assert {len(word) for word in words} <= {3}


def test_among_many_robots_only_those_with_something_special_cover_a_label_to_have_an_arrow() -> None:
    many = tuple(robot(n, 4 * n - 28) for n in range(1, 15))
    label = SceneVertex("1", many[4].pose.x - 5 * CELL, 5.0, label="Wardrobes")
    low = replace(CAMERA, height=4)

    def arrows(*robots: SceneRobot, vertices: tuple[SceneVertex, ...] = (label,)) -> int:
        scene = replace(EMPTY, robots=robots, vertices=vertices)
        text = picture(backdrop(scene, low, MapOptions()), scene, low, MapOptions()).text()
        assert re.findall(r"\d+", text) == [str(one.number) for one in many]
        return text.count("→")

    assert arrows(*many, vertices=()) == len(many)
    assert arrows(*many) < len(many)
    assert arrows(*(one._replace(waits=True) for one in many)) == len(many)


def test_a_robot_that_may_need_a_person_soon_is_amber_and_an_alarm_is_told_where_there_is_space() -> None:
    assert StyleRole.ROBOT_WARN in roles(robot(1, 0)._replace(waits=True))
    assert StyleRole.ROBOT_WARN in roles(robot(1, 0, obstacle=True))
    assert StyleRole.ROBOT_WARN in roles(robot(1, 0)._replace(acknowledged=True))
    stuck = robot(7, 0)._replace(alarmed=True, said="stuck 61 s")
    assert "7! stuck 61 s→" in drawn((stuck,))
    assert "8,7! stuck 61 s→" in drawn((stuck, robot(8, 0)))
    assert "stuck" not in drawn((stuck,), camera=replace(CAMERA, width=80))
