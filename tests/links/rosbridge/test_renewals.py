"""Silent topics are subscribed again, ever more seldom."""

from fleet_tui.links.rosbridge.renewals import FIRST_RENEWAL, LONGEST_INTERVAL, PER_TOPIC, Renewals


def test_only_who_is_silent_is_due_and_the_wait_doubles() -> None:
    renewals = Renewals({"a", "b"}, 10)
    first = FIRST_RENEWAL + 10 * PER_TOPIC
    renewals.start(0.0)
    assert renewals.due(first - 0.1, {}) == (set(), 0.0)
    silent, release = renewals.due(first + 0.1, {"b": first})
    assert silent == {"a"} and release == first / 4
    assert renewals.due(2.7 * first, {"b": 2.5 * first})[0] == set()
    assert renewals.due(3.5 * first, {"b": 3.4 * first})[0] == {"a"}


def test_the_wait_has_a_limit_and_ends_with_a_message() -> None:
    renewals = Renewals({"a"}, 0)
    renewals.start(0.0)
    now, waits = 0.0, list[float]()
    for _ in range(8):
        before = now
        while not renewals.due(now, {})[0]:
            now += 0.5
        waits.append(now - before)
    assert waits == sorted(waits) and waits[-1] <= LONGEST_INTERVAL + 1.0
    assert renewals.due(now + FIRST_RENEWAL, {"a": now + 0.1})[0] == set()
    assert renewals.due(now + FIRST_RENEWAL + 0.2, {"a": now + 0.1})[0] == {"a"}


def test_a_topic_is_silent_by_its_own_rhythm() -> None:
    renewals = Renewals({"a"}, 0)
    renewals.start(0.0)
    assert renewals.due(1.0, {"a": 0.5})[0] == set()
    assert renewals.due(7.0, {"a": 6.5})[0] == set()
    assert renewals.due(24.0, {"a": 6.5})[0] == set(), "it paused for six seconds before"
    assert renewals.due(25.0, {"a": 6.5})[0] == {"a"}
