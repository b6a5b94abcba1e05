"""Lists of a bridge, and the one name among several that is meant."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.order import natural
from fleet_tui.robots.discovery import Discovery, Listed


def test_names_that_no_config_can_hold_are_left_out() -> None:
    listed = Listed(
        {"/a/pose": "x/Y", '/a"b': "x/Y", "no_slash": "x/Y", "/c": 'x"/Y'}, {"/s\n": "x/Y"}, ("/go", "//")
    )
    assert listed.sane() == Listed({"/a/pose": "x/Y"}, {}, ("/go",))


def test_the_one_candidate_is_taken_and_several_are_left_to_a_person() -> None:
    found = Discovery()
    assert (
        found.choose("topics", "battery", ["/{robot}/power"], "/{robot}/battery", "a/B") == "/{robot}/power"
    )
    assert found.choose("topics", "pose", ["/a/amcl", "/a/my_pose"], "/{robot}/pose", "a/B") == "/a/my_pose"
    assert found.notes["topics"] == ["pose: also possible: /a/amcl"]
    assert found.candidates == {("topics", "pose"): ["/a/amcl", "/a/my_pose"]}


def test_where_nothing_sounds_like_it_nothing_is_taken() -> None:
    found = Discovery()
    assert found.choose("topics", "queue", ["/a/x", "/a/y"], "/{robot}/queue", "a/B") == ""
    assert found.choose("topics", "cargo", [], "/{robot}/cargo", "a/B") == ""
    assert found.notes["topics"] == [
        'queue = "...", one of /a/x, /a/y?',
        'cargo = "...": no topic of type a/B',
    ]
    assert found.absent == {"cargo"}


def test_floors_are_those_of_all_robots_and_of_none_each_once() -> None:
    assert Discovery({"a": ["hall", "roof"], "b": ["hall"]}, more_floors=["cellar", "hall"]).floors == [
        *("hall", "roof", "cellar")
    ]


def test_two_comes_before_ten() -> None:
    assert sorted(["robot_10", "robot_2", "amr"], key=natural) == ["amr", "robot_2", "robot_10"]


@given(st.lists(st.text(max_size=12)))
def test_any_names_have_an_order(names: list[str]) -> None:
    ordered = sorted(names, key=natural)
    assert sorted(ordered, key=natural) == ordered
