"""Changes of rates never come as a storm, and always come in the end."""

from collections.abc import Mapping

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.links.rates.plan import HOLD, RatePlan
from fleet_tui.model.attention import Intervals

FULL, SHOWN, SELDOM = Intervals(), Intervals(200, 2000), Intervals(1000, 2000)
ROBOTS = tuple(f"robot_{n}" for n in range(12))
WANTED = st.fixed_dictionaries(dict.fromkeys(ROBOTS, st.sampled_from((FULL, SHOWN, SELDOM))))
TOPICS = 5


def topics(_robot: str, before: Intervals, after: Intervals) -> int:
    return (before.pose != after.pose) + (TOPICS - 1) * (before.status != after.status)


def plan(per_second: int = 10, at: float = 0.0) -> RatePlan:
    made = RatePlan(per_second, topics)
    made.begin(dict.fromkeys(ROBOTS, SELDOM), at)
    return made


def all_of(intervals: Intervals) -> dict[str, Intervals]:
    return dict.fromkeys(ROBOTS, intervals)


def test_a_faster_rate_comes_at_once_and_stays_for_a_while() -> None:
    made = plan()
    looked = {**all_of(SELDOM), "robot_3": FULL}
    assert made.due(looked, 1.0) == [("robot_3", SELDOM)]
    assert made.due(looked, 2.0) == []
    assert made.due(all_of(SELDOM), 2.0 + HOLD - 0.1) == []
    assert made.due(all_of(SELDOM), 2.0 + HOLD) == [("robot_3", FULL)]
    assert made.asked == all_of(SELDOM)


def test_who_pans_back_and_forth_changes_nothing() -> None:
    made = plan(per_second=100)
    there = {**all_of(SELDOM), "robot_1": SHOWN}
    assert len(made.due(there, 0.0)) == 1
    for n in range(20):
        assert made.due(there if n % 2 else all_of(SELDOM), n * HOLD / 3) == []


def test_the_fastest_comes_before_those_that_are_only_shown() -> None:
    made = plan(per_second=1)
    wanted = {**all_of(SHOWN), "robot_9": FULL}
    assert made.due(wanted, 1.0) == [("robot_9", SELDOM)]
    # Its five topics were more than a second's: the next change waits for that.
    assert [made.due(wanted, 1.0 + n) for n in (1, 2, 3, 4)] == [[]] * 4
    assert len(made.due(wanted, 6.0)) == 1


@given(st.lists(st.tuples(st.floats(0.0, 3.0), WANTED), max_size=30), st.integers(1, 30))
def test_no_storm_whatever_is_looked_at(looks: list[tuple[float, dict[str, Intervals]]], most: int) -> None:
    made, now, changed = plan(most), 0.0, 0
    for pause, wanted in looks:
        now += pause
        before: Mapping[str, Intervals] = dict(made.asked)
        for robot, earlier in made.due(wanted, now):
            assert before[robot] == earlier != made.asked[robot]
            changed += topics(robot, earlier, made.asked[robot])
        # A second's worth may be saved up, and the last robot may have more topics than are left.
        assert changed <= most * (now + 1) + TOPICS


@given(st.lists(WANTED, max_size=5), WANTED, st.integers(1, 30))
def test_in_the_end_every_robot_has_the_rate_that_is_wanted(
    before: list[dict[str, Intervals]], wanted: dict[str, Intervals], most: int
) -> None:
    made, now = plan(most), 0.0
    for one in before:
        now += 1.0
        made.due(one, now)
    for _ in range(int(HOLD) + 2 + TOPICS * len(ROBOTS) // most * 2):
        now += 1.0
        made.due(wanted, now)
    assert made.asked == wanted


@given(st.lists(st.tuples(st.floats(0.0, HOLD), WANTED), max_size=30))
def test_no_robot_is_slowed_down_while_it_was_looked_at_a_moment_ago(
    looks: list[tuple[float, dict[str, Intervals]]],
) -> None:
    made, now, full_at = plan(1000), 0.0, dict[str, float]()
    for pause, wanted in looks:
        now += pause
        made.due(wanted, now)
        full_at |= {robot: now for robot in ROBOTS if wanted[robot] == FULL}
        assert all(made.asked[robot] == FULL for robot, at in full_at.items() if now - at < HOLD)
