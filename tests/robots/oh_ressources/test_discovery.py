"""The source's robots among what a bridge lists: by their queues, else by their poses."""

from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.oh_ressources.discovery import discover
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY

TOPICS, SERVICES = VOCABULARY.topics, VOCABULARY.services


def usual(robot: str, floor: str = "hall", **types: str) -> dict[str, str]:
    return {
        name.format(robot=robot, floor=floor): types.get(key, type_)
        for key, (name, type_) in TOPICS.items()
        if name
    }


def services(robot: str) -> dict[str, str]:
    return {name.format(robot=robot): type_ for name, type_ in SERVICES.values()}


def test_usual_robots_need_nothing_else() -> None:
    found = discover(Listed(usual("r1") | usual("r2"), services("r1") | services("r2")))
    assert found.robots == {"r1": ["hall"], "r2": ["hall"]}
    assert not (found.topics or found.types or found.services or found.notes or found.is_guess)
    assert found.live_maps == {"hall"}


def test_a_topic_of_another_name_is_found_by_its_type() -> None:
    topics = {("/r1/power" if name == "/r1/battery" else name): type_ for name, type_ in usual("r1").items()}
    assert discover(Listed(topics, services("r1"))).topics == {"battery": "/{robot}/power"}


def test_types_that_are_read_alike_and_spellings_of_ros_2_are_taken() -> None:
    found = discover(Listed(usual("r1", battery="std_msgs/Float64"), services("r1")))
    assert found.types == {"battery": "std_msgs/Float64"}
    other = discover(Listed(usual("r1", queue="oh_ressources/msg/ActionQueue"), services("r1")))
    assert other.types == {"queue": "oh_ressources/msg/ActionQueue"} and other.robots == {"r1": ["hall"]}


def test_a_service_of_another_type_is_noted_and_one_that_tells_none_is_not() -> None:
    key, (name, _) = next(iter(SERVICES.items()))
    for type_, notes in (
        ("other_msgs/Other", f'{key} = "other_msgs/Other"   # if the fields match'),
        ("", ""),
    ):
        there = services("r1") | {name.format(robot="r1"): type_}
        assert notes in str(discover(Listed(usual("r1"), there)).notes) and bool(notes) is bool(
            discover(Listed(usual("r1"), there)).notes
        )


def test_poses_alone_are_a_guess() -> None:
    found = discover(Listed({"/r1/pose": "geometry_msgs/PoseStamped"}, {}))
    assert found.is_guess and found.robots == {"r1": []}
    assert "queue" in found.absent


def test_robots_below_one_name_have_a_slash_in_theirs() -> None:
    queue = TOPICS["queue"][1]
    found = discover(Listed({f"/site/r{n}/queue": queue for n in (10, 9)}, {}))
    assert list(found.robots) == ["site/r9", "site/r10"]
