"""Which topics are asked about: a few of robots that look alike, and nothing is lost by that."""

from fleet_tui.links.discovery.questions import (
    alike,
    next_questions,
    silent,
    telling_services,
    telling_topics,
)
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY

POSE, QUEUE = VOCABULARY.topics["pose"][1], VOCABULARY.topics["queue"][1]


def listed(robots: int) -> dict[str, str]:
    return {
        f"/robot_{n}/{name}": type_
        for n in range(robots)
        for name, type_ in (("goal_pose", POSE), ("pose", POSE), ("queue", QUEUE))
    }


def asked(topics: dict[str, str], published: set[str]) -> tuple[set[str], dict[str, tuple[str, ...]]]:
    """Ask as discovery does: the topics found silent, and every answer."""
    groups, answers = alike(topics), dict[str, tuple[str, ...]]()
    while names := [name for spaces in groups for name in next_questions(spaces, answers)]:
        answers |= {name: ("/node",) if name in published else () for name in names}
    return {name for spaces in groups for name in silent(spaces, answers)}, answers


def test_of_robots_that_look_alike_most_are_asked_one_question() -> None:
    topics = listed(100)
    published = {name for name in topics if "goal_pose" not in name}
    found, answers = asked(topics, published)
    assert found == topics.keys() - published
    assert len(answers) == 2 * 3 + 98


def test_robots_that_a_console_asks_for_in_vain_are_not_there_wherever_they_stand() -> None:
    topics = listed(6)
    published = {name for name in topics if name.startswith(("/robot_2/", "/robot_3/", "/robot_5/"))}
    found, _ = asked(topics, published)
    assert found == topics.keys() - published


def test_nobody_there_at_all() -> None:
    topics = listed(4)
    assert asked(topics, set())[0] == set(topics)


def test_what_is_not_asked_counts_as_listed() -> None:
    (spaces,) = alike(listed(5))
    assert list(silent(spaces, {})) == []


def test_robots_under_one_roof_are_told_apart() -> None:
    topics = {f"/site/robot_{n}/{name}": POSE for n in range(4) for name in ("pose", "goal_pose")}
    assert len(asked(topics, set(topics))[1]) == 2 * 2 + 2


def test_topics_of_other_types_and_services_of_every_node_tell_nothing() -> None:
    assert list(telling_topics({"/r/pose": POSE, "/r/scan": "sensor_msgs/LaserScan"})) == ["/r/pose"]
    services = ["/rosapi/topics", "/rosbridge_websocket/get_loggers", "/r/get_parameters", "/r/Pause"]
    assert list(telling_services(services)) == ["/r/Pause"]


def test_robots_are_asked_about_before_plain_values() -> None:
    topics = {f"/a_{n}/text": "std_msgs/String" for n in range(3)} | listed(1)
    first, *_ = alike(topics)
    assert "queue" in first[0]
