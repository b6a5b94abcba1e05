"""Listening on a bridge: what is counted of a topic, and when."""

from fleet_tui.links.discovery.wire import TopicListening
from fleet_tui.model.events import Event, TimePassed
from fleet_tui.robots.adapter import Feed


def test_a_message_that_is_being_read_is_not_one_that_can_not_be_read() -> None:
    """A large map takes its time on a thread, and the facts may be asked for meanwhile."""
    seen = []

    def read(_feed: Feed, _msg: object, at: float) -> list[Event]:
        seen.append(received.facts(at).count)
        return [TimePassed(at, at)]

    received = TopicListening(Feed("map", ("robot_0",), "floor_0", "/map", ""), 0.0, read)
    received.take({}, 1.0)
    facts = received.facts(2.0)
    assert seen == [0] and (facts.count, facts.event) == (1, TimePassed(1.0, 1.0))
