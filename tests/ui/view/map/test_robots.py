"""Robots on the map: chips whose numbers stay at their arrows."""

import re
from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.places import seen_robots
from fleet_tui.ui.view.map.robots import FEW, Arrangement
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import StyleRole

CAMERA = Camera.fit((400, 200), 120, 40)
SMALL = Camera.fit((400, 200), 30, 10)
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


def test_each_robot_is_a_chip_of_its_own_its_arrow_before_its_number() -> None:
    assert " →1 " in drawn((robot(1, 0),))
    assert " →1  →2 " in drawn((robot(1, 0), robot(2, 4)))
    assert " →2 →1 " in drawn((robot(1, 0), robot(2, -3)))
    for cell in range(3):
        text = drawn((robot(1, 0), robot(2, cell)))
        assert "→1" in text and "→2" in text and "," not in text


def test_a_chip_keeps_its_place_at_the_robot_while_that_drives() -> None:
    before = Arrangement()
    for cell in range(-9, 10):
        row = next(row for row in drawn((robot(1, cell),), before).split("\n") if "1" in row)
        assert row.index("→1") == 60 + cell


def many(*others: SceneRobot, camera: Camera = SMALL) -> str:
    """Robots on a floor that is small for them, most of them out of the view."""
    away = SceneRobot("away", 99, Pose(-5.0, -5.0))
    return drawn((*others, *[away] * FEW), camera=camera)


def test_on_a_crowded_floor_numbers_come_first_and_arrows_stay_where_there_is_space() -> None:
    one, other = robot(1, 0), robot(2, 9)
    assert {"→1", "→2"} <= set(many(one, other).split())
    close = [robot(number, number * 8 - 40) for number in range(1, 8)]
    rows = [row for row in many(*close).split("\n") if row.strip()]
    assert len(rows) == 1 and set(re.findall(r"\d", rows[0])) == set("1234567"), "no arrow moves a number"


def test_on_a_crowded_floor_robots_in_one_cell_are_spread_around_it_and_counted_only_without_space() -> None:
    calm = tuple(robot(number, 0) for number in range(1, 6))
    text = many(*calm)
    assert "×" not in text and set(re.findall(r"\d", text)) == set("12345")
    assert len([row for row in text.split("\n") if row.strip()]) <= 3, "within a row of their cell"
    assert "×5" in many(*calm, camera=Camera.fit((400, 200), 3, 1))
    special = many(calm[0]._replace(selected=True), calm[1]._replace(alarmed=True), *calm[2:])
    assert "→1" in special and "→2!" in special


def test_a_robot_at_the_end_of_its_mission_is_over_it() -> None:
    there = SceneVertex("7", 10.05, 5.0, label="Store")
    at_end = replace(EMPTY, robots=(robot(1, 0),), vertices=(there,), target_vertices=("7",))
    text = picture(backdrop(at_end, CAMERA, MapOptions()), at_end, CAMERA, MapOptions()).text()
    row = next(row for row in text.split("\n") if "→1" in row)
    assert 60 - len("→1") < row.index("→1") <= 60
    beside = replace(at_end, robots=(robot(1, 1),))
    assert "o" in picture(
        backdrop(beside, CAMERA, MapOptions()), beside, CAMERA, MapOptions()
    ).text().replace("Store", "")


def test_robots_in_one_cell_have_each_a_number_the_one_in_trouble_nearest() -> None:
    rows = drawn((robot(1, 0), robot(2, 0), robot(3, 0, obstacle=True))).split("\n")
    assert all(any(chip in row for row in rows) for chip in ("→1", "→2", "→3!"))
    assert next(row for row in rows if "→3!" in row).index("→3!") == 60


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
    rows = drawn((seen, new)).split("\n")
    assert next(row for row in rows if "→2!" in row).index("→2!") == 60, "it is over its own cell"


def test_the_age_of_a_pose_is_told_where_there_is_space() -> None:
    one = robot(8, 0)._replace(online=False, age=13.0)
    assert "→8 (13 s)" in drawn((one,))
    narrow = replace(CAMERA, width=80)
    assert "→8○" in drawn((one,), camera=narrow)
    assert "→8 (13 s)" in drawn((one._replace(selected=True),), camera=narrow)


def test_a_robot_without_space_beside_its_arrow_has_its_number_in_place_of_it() -> None:
    one = robot(7, 0)
    assert drawn((one,), camera=Camera.fit((400, 200), 1, 1)).strip() == "7"
    assert drawn((one._replace(mark="17"),), camera=Camera.fit((400, 200), 1, 1)).strip() == "→"


def test_the_selected_robot_has_its_chip_over_its_own_cell_whoever_is_there() -> None:
    crowd = tuple(robot(number, number - 6) for number in range(1, 12))
    selected = crowd[5]._replace(selected=True)
    rows = drawn((*crowd[:5], selected, *crowd[6:])).split("\n")
    assert next(row for row in rows if "→6" in row).index("→6") == 60


def test_the_age_of_an_old_pose_covers_no_label() -> None:
    old = robot(1, 0)._replace(online=False, age=18.0)
    assert "→1 (18 s)" in drawn((old,))
    labelled = replace(
        EMPTY,
        robots=(old,),
        vertices=tuple(SceneVertex(str(n), 10.05 + n * 4 * CELL, 5.0, label="Receive") for n in (-1, 1)),
    )
    text = picture(backdrop(labelled, CAMERA, MapOptions()), labelled, CAMERA, MapOptions()).text()
    assert text.count("Receive") == 2
    assert "→1○" in text


def test_robots_that_drive_past_each_other_keep_their_numbers_apart_and_the_arrow_first() -> None:
    before = Arrangement()
    for column in range(-8, 9):
        words = drawn((robot(1, 0), robot(2, column)), before).split()
        assert sorted(words) == ["→1", "→2"]


@given(st.lists(st.tuples(st.floats(9.0, 11.0), st.floats(4.5, 5.5)), min_size=2, max_size=9))
def test_two_numbers_never_read_as_one(at: list[tuple[float, float]]) -> None:
    robots = tuple(SceneRobot(f"r{n}", n, Pose(*place), mark=str(100 + n)) for n, place in enumerate(at))
    counted = re.sub(r"×\d+", " ", drawn(robots))
    words = "".join(letter if letter.isdigit() else " " for letter in counted).split()
    assert {len(word) for word in words} <= {3}


def test_a_robot_that_may_need_a_person_soon_is_amber_and_an_alarm_is_told_where_there_is_space() -> None:
    assert StyleRole.ROBOT_WARN in roles(robot(1, 0)._replace(waits=True))
    assert StyleRole.ROBOT_WARN in roles(robot(1, 0, obstacle=True))
    assert StyleRole.ROBOT_WARN in roles(robot(1, 0)._replace(acknowledged=True))
    stuck = robot(7, 0)._replace(alarmed=True, said="stuck 61 s")
    assert "→7! stuck 61 s" in drawn((stuck,))
    assert "stuck" not in drawn((stuck,), camera=replace(CAMERA, width=80))


def test_robots_piled_up_in_one_cell_are_counted_and_none_of_them_is_lost() -> None:
    piled = tuple(robot(n, 0) for n in range(1, 8))
    assert "×7" in drawn(piled)
    shown = drawn((*piled[:6], piled[6]._replace(obstacle=True)))
    assert "×6" in shown and "7!" in shown
    assert "×" not in drawn(piled[:4])


some_states = st.builds(
    SceneRobot,
    *(st.just(""), st.just(1), st.just(Pose(0.0, 0.0))),
    age=st.just(18.0),
    said=st.just("order -> Archive failed (a stop was missed)"),
    **dict.fromkeys(("online", "alarmed", "obstacle", "selected", "paused", "jumped"), st.booleans()),
)
some_robots = st.lists(
    st.tuples(st.floats(-1.0, 21.0), st.floats(3.0, 6.0), some_states), min_size=1, max_size=25
)
names_of_places = st.lists(st.tuples(st.floats(0.0, 20.0), st.floats(3.0, 6.0)), max_size=12)


@given(some_robots, names_of_places, st.sampled_from([60, 100, 160]))
def test_an_arrow_and_its_number_stand_at_their_robot_whatever_text_is_beside_them(
    at: list[tuple[float, float, SceneRobot]], places: list[tuple[float, float]], width: int
) -> None:
    robots = tuple(
        robot._replace(name=f"r{n}", number=n, pose=Pose(x, y), mark=str(100 + n))
        for n, (x, y, robot) in enumerate(at)
    )
    vertices = tuple(SceneVertex(str(n), *place, label="Receiving") for n, place in enumerate(places))
    scene, camera = replace(EMPTY, robots=robots, vertices=vertices), Camera.fit((400, 200), width, 30)
    cells = picture(backdrop(scene, camera, MapOptions()), scene, camera, MapOptions())
    rows = cells.text().split("\n")
    for robot, (x, y) in seen_robots(scene, camera):
        for row, text in enumerate(rows):
            start, chip = text.find(robot.mark), text.partition(robot.mark)[2].split(" ")[0]
            is_near = start - 3 <= x <= start + len(robot.mark + chip) + 1 and abs(row - y) <= 1
            is_last_resort = abs(row - y) == 2 and cells.roles[y, x] >= StyleRole.ROBOT
            assert start < 0 or is_near or is_last_resort


def test_an_alarms_text_is_on_the_other_side_where_the_view_ends() -> None:
    for cells, chip in ((0, "→5! stuck 61 s"), (57, "stuck 61 s →5!")):
        stuck = robot(5, cells)._replace(alarmed=True, said="stuck 61 s")
        row = next(row for row in drawn((stuck,)).split("\n") if "5!" in row)
        assert row.strip() == chip and abs(row.index("→5!") - 60 - cells) <= 1


def test_an_alarms_text_beside_its_robot_is_short_and_whole_or_left_to_the_alarms_pane() -> None:
    for said, chip in (
        ("order -> Archive failed (a stop was missed)", "→5! order -> Archive failed"),
        ("battery 8 %, charge it within ten minutes", "→5! battery 8 %"),
        ("two robots do not get past each other", "→5!"),
    ):
        text = drawn((robot(5, 0)._replace(alarmed=True, said=said),))
        assert next(row for row in text.split("\n") if "5!" in row).strip() == chip


def test_who_is_off_the_map_stands_exactly_there_although_a_place_beside_it_would_hide_less() -> None:
    place = SceneVertex("1", 10.05, 5.0, label="Base"), SceneVertex("2", 10.05, 4.0, label="Gate")
    for n in range(8):
        lost = robot(1, n)._replace(misplaced=True)
        scene = replace(EMPTY, vertices=place, robots=(lost,))
        text = picture(backdrop(scene, CAMERA, MapOptions()), scene, CAMERA, MapOptions()).text()
        at = seen_robots(scene, CAMERA)[0][1]
        assert text.split("\n")[at[1]][at[0] :].startswith("→1?"), n
