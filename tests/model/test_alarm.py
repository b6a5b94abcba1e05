"""An alarm stays until its condition is over and a person has seen it, and goes only along its table."""

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule
from msgspec import structs

from fleet_tui.model.alarm import (
    TRANSITIONS,
    Alarm,
    AlarmStage,
    AlarmStep,
    Condition,
    Key,
    Priority,
    acknowledge,
    advance,
    shelve,
    transitions,
    unshelve,
)
from fleet_tui.text.language import Message

KINDS = [(source, kind) for source in ("robot_0", "robot_1") for kind in ("offline", "obstacle")]
KEY = ("robot_0", "obstacle")


def condition(
    source: str = "robot_0", kind: str = "obstacle", text: str = "obstacle 3.2 s", parts: str = ""
) -> Condition:
    return Condition(
        source, kind, Priority.HIGH, Message(text), Message("cleared: obstacle"), parts=frozenset(parts)
    )


def one(alarms: tuple[Alarm, ...]) -> Alarm:
    (alarm,) = alarms
    return alarm


def test_raised_with_the_wall_time_of_the_first_moment() -> None:
    alarm = one(advance((), [condition()], at=10.0, wall=1_700_000_010.0))
    assert (alarm.stage, alarm.count) == (AlarmStage.UNACKNOWLEDGED, 1)
    assert (alarm.first_wall, alarm.last_wall) == (1_700_000_010.0, 1_700_000_010.0)
    later = one(advance((alarm,), [condition(text="obstacle 9.9 s")], at=17.0, wall=1_700_000_017.0))
    assert (later.first_wall, later.last_wall, later.count) == (1_700_000_010.0, 1_700_000_017.0, 1)
    assert later.text == "obstacle 9.9 s"


def test_over_but_unseen_it_stays_in_other_words() -> None:
    alarms = advance((), [condition()], 1.0, 1.0)
    over = one(advance(alarms, [], 2.0, 2.0))
    assert (over.stage, over.text) == (AlarmStage.RETURNED, "cleared: obstacle")
    assert acknowledge((over,), *KEY) == ()


def test_where_nothing_changes_they_are_the_same_object() -> None:
    over = advance(advance((), [condition()], 1.0, 1.0), [], 2.0, 2.0)
    assert advance(over, [], 3.0, 3.0) is over
    assert advance(over, [condition(kind="battery")], 3.0, 3.0)[:-1] == over
    assert advance((), [], 3.0, 3.0) == ()


def test_seen_while_it_holds_it_goes_with_its_condition() -> None:
    seen = acknowledge(advance((), [condition()], 1.0, 1.0), *KEY)
    assert one(seen).stage is AlarmStage.ACKNOWLEDGED
    assert one(advance(seen, [condition()], 2.0, 2.0)).stage is AlarmStage.ACKNOWLEDGED
    assert advance(seen, [], 3.0, 3.0) == ()


def test_come_again_it_counts() -> None:
    alarms = advance((), [condition()], 1.0, 100.0)
    alarms = advance(advance(alarms, [], 2.0, 101.0), [condition()], 3.0, 102.0)
    again = one(alarms)
    assert (again.count, again.stage, again.first_wall) == (2, AlarmStage.UNACKNOWLEDGED, 100.0)


def test_what_comes_back_within_the_delay_is_the_same_alarm_and_counts() -> None:
    alarms = acknowledge(advance((), [condition()], 1.0, 1.0), *KEY)
    for n in range(1, 50):
        alarms = advance(alarms, [condition()] if n % 2 else [], 1.0 + n, 1.0 + n, clear_after=3.0)
        assert one(alarms).stage is AlarmStage.ACKNOWLEDGED
        assert one(alarms).text == ("obstacle 3.2 s" if n % 2 else "cleared: obstacle")
    assert one(alarms).count == 25


def test_the_delay_counts_from_when_it_held_last() -> None:
    alarms = advance((), [condition()], 1.0, 1.0)
    alarms = advance(alarms, [condition()], 5.0, 5.0, clear_after=3.0)
    assert one(advance(alarms, [], 7.9, 7.9, clear_after=3.0)).stage is AlarmStage.UNACKNOWLEDGED
    assert one(advance(alarms, [], 8.0, 8.0, clear_after=3.0)).stage is AlarmStage.RETURNED


def test_what_gets_worse_needs_another_look() -> None:
    low = structs.replace(condition(), priority=Priority.LOW)
    seen = acknowledge(advance((), [low], 1.0, 1.0), *KEY)
    worse = advance(seen, [structs.replace(low, priority=Priority.MEDIUM)], 2.0, 2.0)
    assert (one(worse).stage, one(worse).count) == (AlarmStage.UNACKNOWLEDGED, 1)
    seen = acknowledge(worse, *KEY)
    assert one(advance(seen, [low], 3.0, 3.0)).stage is AlarmStage.ACKNOWLEDGED


def test_new_parts_count_and_need_another_look() -> None:
    seen = acknowledge(advance((), [condition(parts="ab")], 1.0, 1.0), *KEY)
    assert one(seen).count == 2
    fewer = advance(seen, [condition(parts="a")], 2.0, 2.0)
    assert (one(fewer).stage, one(fewer).count) == (AlarmStage.ACKNOWLEDGED, 2)
    more = advance(fewer, [condition(parts="acde")], 3.0, 3.0)
    assert (one(more).stage, one(more).count) == (AlarmStage.UNACKNOWLEDGED, 5)


def test_acknowledging_one_leaves_the_others() -> None:
    alarms = advance((), [condition(), condition(kind="battery"), condition("robot_1")], 1.0, 1.0)
    after = acknowledge(alarms, *KEY)
    assert [alarm.needs_acknowledgement for alarm in after] == [False, True, True]
    assert acknowledge(alarms, "robot_7", "obstacle") == alarms
    assert not any(alarm.needs_acknowledgement for alarm in acknowledge(alarms, "", ""))


def test_the_oldest_stands_first() -> None:
    alarms = advance((), [condition("robot_1")], 1.0, 1.0)
    alarms = advance(alarms, [condition("robot_0"), condition("robot_1")], 2.0, 2.0)
    assert [alarm.condition.source for alarm in alarms] == ["robot_1", "robot_0"]


def test_on_the_shelf_it_is_quiet_until_the_time_is_over() -> None:
    alarms = shelve(advance((), [condition()], 1.0, 1.0), KEY, until=10.0)
    for at, holding in ((2.0, True), (3.0, False), (9.9, True)):
        alarms = advance(alarms, [condition()] if holding else [], at, at)
        assert one(alarms).stage is AlarmStage.SHELVED
        assert acknowledge(alarms, "", "") == alarms
    assert one(alarms).count == 2
    assert one(advance(alarms, [condition()], 10.0, 10.0)).stage is AlarmStage.UNACKNOWLEDGED
    assert advance(alarms, [], 10.0, 10.0) == ()


@pytest.mark.parametrize("holding", [True, False])
def test_taken_off_the_shelf_it_is_what_it_would_be(holding: bool) -> None:
    alarms = advance(
        shelve(advance((), [condition()], 1.0, 1.0), KEY, 99.0), [condition()] * holding, 2.0, 2.0
    )
    after = unshelve(alarms, KEY)
    assert [alarm.stage for alarm in after] == [AlarmStage.UNACKNOWLEDGED] * holding
    assert unshelve(after, KEY) == after


def test_a_later_word_moves_the_end_of_the_shelf() -> None:
    alarms = shelve(shelve(advance((), [condition()], 1.0, 1.0), KEY, 5.0), KEY, 50.0)
    assert one(advance(alarms, [condition()], 49.0, 49.0)).stage is AlarmStage.SHELVED


def test_history_tells_each_step_with_its_wall_time() -> None:
    told: list[tuple[str, str, float]] = []
    alarms: tuple[Alarm, ...] = ()

    def then(after: tuple[Alarm, ...], wall: float) -> None:
        nonlocal alarms
        told.extend((step.word, step.now.value, step.wall) for step in transitions(alarms, after, wall))
        alarms = after

    then(advance(alarms, [condition()], 1.0, 101.0), 101.0)
    then(advance(alarms, [condition()], 2.0, 102.0), 102.0)
    then(advance(alarms, [], 3.0, 103.0), 103.0)
    then(advance(alarms, [condition()], 4.0, 104.0), 104.0)
    then(acknowledge(alarms, *KEY), 104.5)
    then(advance(alarms, [condition(parts="a")], 5.0, 105.0), 105.0)
    then(shelve(alarms, KEY, 9.0), 105.5)
    then(unshelve(alarms, KEY), 106.0)
    then(advance(alarms, [], 7.0, 107.0), 107.0)
    then(acknowledge(alarms, *KEY), 108.0)
    assert told == [
        ("raised", "unacknowledged", 101.0),
        ("returned", "returned unacknowledged", 103.0),
        ("raised again", "unacknowledged", 104.0),
        ("acknowledged", "acknowledged", 104.5),
        ("worse", "unacknowledged", 105.0),
        ("shelved", "shelved", 105.5),
        ("unshelved", "unacknowledged", 106.0),
        ("returned", "returned unacknowledged", 107.0),
        ("acknowledged", "cleared", 108.0),
    ]


def test_two_stages_are_joined_by_one_step_at_most() -> None:
    """So that a history can be told from what was there before and after."""
    ways = [(was, now) for (was, _), now in TRANSITIONS.items()]
    assert len(ways) == len(set(ways))


@given(st.lists(st.sets(st.sampled_from(KINDS)), max_size=20))
def test_it_counts_how_often_its_condition_began(looks: list[set[Key]]) -> None:
    alarms: tuple[Alarm, ...] = ()
    began = dict.fromkeys(KINDS, 0)
    before: set[Key] = set()
    for n, holding in enumerate(looks):
        alarms = advance(alarms, [condition(*key) for key in sorted(holding)], float(n), float(n), 1.5)
        for key in holding - before:
            began[key] += 1
        before = holding
    assert {alarm.key: alarm.count for alarm in alarms} == {key: n for key, n in began.items() if n}


class Alarms(RuleBasedStateMachine):
    """Every alarm goes only along the table, and nothing unseen is ever lost. A second memory keeps
    what holds, since when it doesn't, and what nobody has seen."""

    CLEAR_AFTER = 2.0

    def __init__(self) -> None:
        super().__init__()
        self.alarms: tuple[Alarm, ...] = ()
        self.held_at: dict[Key, float] = {}
        self.unseen: set[Key] = set()
        self.shelf: dict[Key, float] = {}
        self.count: dict[Key, int] = {}
        self.holding: set[Key] = set()
        self.at = 0.0

    def _then(self, change: Callable[[], tuple[Alarm, ...]]) -> None:
        before = {alarm.key: alarm.stage for alarm in self.alarms}
        old, self.alarms = self.alarms, change()
        after = {alarm.key: alarm.stage for alarm in self.alarms}
        steps = {(step.alarm.key, step.was, step.now): step for step in transitions(old, self.alarms, 0.0)}
        for key in before.keys() | after.keys():
            was, now = before.get(key, AlarmStage.CLEARED), after.get(key, AlarmStage.CLEARED)
            if was is not now:
                assert TRANSITIONS[was, steps.pop((key, was, now)).step] is now
                assert not (was is AlarmStage.UNACKNOWLEDGED and now is AlarmStage.CLEARED)
        assert not steps

    @rule(holding=st.sets(st.sampled_from(KINDS)))
    def look(self, holding: set[Key]) -> None:
        self.at += 1.0
        conditions = [condition(*key) for key in sorted(holding)]
        known = {alarm.key for alarm in self.alarms}
        returned = {alarm.key for alarm in self.alarms if alarm.stage is AlarmStage.RETURNED}
        self._then(lambda: advance(self.alarms, conditions, self.at, self.at, self.CLEAR_AFTER))
        for key in holding:
            if key not in self.holding or key not in known:
                self.count[key] = self.count[key] + 1 if key in known else 1
            self.held_at[key] = self.at
        self.unseen |= (holding - known) | (holding & returned)
        self.holding = holding
        for key, until in list(self.shelf.items()):
            if self.at >= until:
                del self.shelf[key]
                self.unseen |= {key} & holding

    @rule(key=st.sampled_from(KINDS))
    def see(self, key: Key) -> None:
        self._then(lambda: acknowledge(self.alarms, *key))
        self.unseen.discard(key)

    @rule()
    def see_all(self) -> None:
        self._then(lambda: acknowledge(self.alarms, "", ""))
        self.unseen.clear()

    @rule(key=st.sampled_from(KINDS), seconds=st.sampled_from([1.0, 4.0]))
    def put_on_the_shelf(self, key: Key, seconds: float) -> None:
        there = key in {alarm.key for alarm in self.alarms}
        self._then(lambda: shelve(self.alarms, key, self.at + seconds))
        if there:
            self.shelf[key] = self.at + seconds
            self.unseen.discard(key)

    @rule(key=st.sampled_from(KINDS))
    def take_off_the_shelf(self, key: Key) -> None:
        self._then(lambda: unshelve(self.alarms, key))
        if self.shelf.pop(key, None) is not None and key in self.holding:
            self.unseen.add(key)

    @invariant()
    def nothing_is_lost_or_doubled(self) -> None:
        keys = [alarm.key for alarm in self.alarms]
        assert len(keys) == len(set(keys))
        assert {alarm.key for alarm in self.alarms if alarm.needs_acknowledgement} == self.unseen
        assert {alarm.key for alarm in self.alarms if alarm.stage is AlarmStage.SHELVED} == set(self.shelf)
        assert {alarm.key for alarm in self.alarms if alarm.holds} == self.holding
        assert {alarm.key: alarm.count for alarm in self.alarms} == {key: self.count[key] for key in keys}

    @invariant()
    def only_what_is_seen_and_over_is_cleared(self) -> None:
        recent = {key for key, at in self.held_at.items() if self.at - at < self.CLEAR_AFTER}
        gone = set(self.held_at) - {alarm.key for alarm in self.alarms}
        assert not gone & (self.unseen | self.holding | set(self.shelf))
        for alarm in self.alarms:
            assert alarm.stage is not AlarmStage.RETURNED or alarm.key not in recent


TestAlarms = Alarms.TestCase


def test_a_step_that_the_table_lacks_changes_nothing() -> None:
    shelved = shelve(advance((), [condition()], 1.0, 1.0), KEY, 9.0)
    assert (AlarmStage.SHELVED, AlarmStep.ACKNOWLEDGE) not in TRANSITIONS
    assert acknowledge(shelved, *KEY) == shelved
