"""The topics that fill an overloaded bridge, named beside the lateness."""

from fleet_tui.model.counters import LinkCounter, TopicCounter
from fleet_tui.model.events import BridgeAnswered, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.why.load import busiest
from fleet_tui.situation.why.why import reasons
from tests.support.fleets import LINK, R0, T0, fleet, link_up, pose, reduced, tick


def counter() -> LinkCounter:
    """Two robots: poses ten times a second, batteries once, queues never."""
    topics = [TopicCounter(f"/r{n}/{kind}", f"r{n}", kind) for n in (0, 1) for kind in ("pose", "battery")]
    found = LinkCounter(LINK, [*topics, TopicCounter("/r0/queue", "r0", "queue")])
    for step in range(41):
        for topic in topics:
            if topic.kind == "pose" or step % 10 == 0:
                topic.take(100, T0 + step / 10)
    return found


def late() -> FleetState:
    """A robot whose poses come ever later, until it is silent."""
    facts: list[Event] = [link_up(T0), pose(T0, stamp=50.0), tick(T0)]
    for n in range(400):
        at, lag = T0 + n / 10, n * 0.05
        facts += [pose(at, stamp=50.0 + at - T0 - lag), BridgeAnswered(LINK, at, lag), tick(at)]
    return reduced(fleet(), *facts)


def test_the_topics_of_all_robots_together_are_named_the_most_frequent_first() -> None:
    found = busiest(counter(), T0 + 4)
    assert found is not None and found.name == "most messages: pose, battery"
    assert found.evidence == "pose 20/s, 2.0 kB/s in 2 topics, battery 2/s, 200 B/s in 2 topics"
    assert found.page == "topics" and busiest(LinkCounter(LINK, []), T0) is None


def test_they_come_after_the_lateness_that_they_explain() -> None:
    state, load = late(), busiest(counter(), T0 + 4)
    names = [one.name for one in reasons(state, state.robots[R0], load=load)]
    assert names[0].startswith("messages 20 s late") and names[1] == "most messages: pose, battery"
