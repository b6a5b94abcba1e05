"""Facts about a bridge: what is there to be heard, and what its silence means."""

import pytest

from fleet_tui.links.discovery.facts import LONG_ENOUGH, RosapiFacts, TopicFacts
from fleet_tui.robots.adapter import Feed

STATUS = "/r1/navigate_to_pose/_action/status"


def test_a_topic_that_nobody_publishes_is_not_there() -> None:
    known = RosapiFacts(topics={"/a": "x/Y", "/b": "x/Y"}, publishers={"/a": ("/node",), "/b": ()})
    assert known.has("/a") and not known.has("/b") and not known.has("/c")
    assert RosapiFacts(topics={"/a": "x/Y"}).has("/a"), "who publishes it was not asked"


def test_topics_of_actions_are_in_no_list() -> None:
    known = RosapiFacts(actions=("/r1/navigate_to_pose",))
    assert known.has(STATUS) and known.lists_action_of(STATUS)
    assert RosapiFacts(actions=("/r2/dock",)).lacks_action_of(STATUS)
    assert not RosapiFacts().lacks_action_of(STATUS)


@pytest.mark.parametrize(
    ("problem", "absent", "silent"),
    [
        ("Service /rosapi/topics does not exist", True, False),
        ("no reply from rosapi", False, True),
        ("Timeout exceeded while waiting for service response", False, True),
        ("", False, False),
    ],
)
def test_why_rosapi_tells_nothing(problem: str, absent: bool, silent: bool) -> None:
    assert (RosapiFacts(problem=problem).is_absent, RosapiFacts(problem=problem).is_silent) == (
        absent,
        silent,
    )


@pytest.mark.parametrize(
    ("silent_kind", "count", "waited", "complaint", "is_silent"),
    [
        (False, 0, LONG_ENOUGH, "", True),
        (False, 0, LONG_ENOUGH / 2, "", False),
        (False, 1, LONG_ENOUGH, "", False),
        (True, 0, LONG_ENOUGH, "", False),
        (True, 0, LONG_ENOUGH, "not allowed", True),
    ],
)
def test_silence_means_something_after_a_while(
    silent_kind: bool, count: int, waited: float, complaint: str, is_silent: bool
) -> None:
    wanted = Feed("pose", ("r1",), "", "/r1/pose", "x/Y", silent=silent_kind)
    assert TopicFacts(wanted, count=count, waited=waited, complaint=complaint).is_silent is is_silent
