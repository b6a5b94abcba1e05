"""An alarm stays until its condition is over and a person has seen it."""

from hypothesis import given
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from fleet_tui.model.alarm import Alarm, Condition, Priority, acknowledge, ripen

KINDS = [(source, kind) for source in ("robot_0", "robot_1") for kind in ("offline", "obstacle")]


def condition(source: str = "robot_0", kind: str = "obstacle", text: str = "obstacle 3.2 s") -> Condition:
    return Condition(source, kind, Priority.HIGH, text, "way is free again")


def one(alarms: tuple[Alarm, ...]) -> Alarm:
    (alarm,) = alarms
    return alarm


def test_raised_with_the_wall_time_of_the_first_moment() -> None:
    alarm = one(ripen((), [condition()], at=10.0, wall=1_700_000_010.0))
    assert (alarm.active, alarm.acknowledged, alarm.count) == (True, False, 1)
    assert (alarm.first_wall, alarm.last_seen) == (1_700_000_010.0, 10.0)
    later = one(ripen((alarm,), [condition(text="obstacle 9.9 s")], at=17.0, wall=1_700_000_017.0))
    assert (later.first_wall, later.last_seen, later.count) == (1_700_000_010.0, 17.0, 1)
    assert later.text == "obstacle 9.9 s"


def test_over_but_unseen_it_stays_in_other_words() -> None:
    alarms = ripen((), [condition()], 1.0, 1.0)
    over = one(ripen(alarms, [], 2.0, 2.0))
    assert (over.active, over.text) == (False, "way is free again")
    assert acknowledge((over,), "robot_0", "obstacle") == ()


def test_seen_while_it_holds_it_goes_with_its_condition() -> None:
    seen = acknowledge(ripen((), [condition()], 1.0, 1.0), "robot_0", "obstacle")
    assert one(seen).acknowledged
    assert one(ripen(seen, [condition()], 2.0, 2.0)).acknowledged
    assert ripen(seen, [], 3.0, 3.0) == ()


def test_come_again_it_counts() -> None:
    alarms = ripen((), [condition()], 1.0, 100.0)
    alarms = ripen(ripen(alarms, [], 2.0, 101.0), [condition()], 3.0, 102.0)
    again = one(alarms)
    assert (again.count, again.active, again.acknowledged, again.first_wall) == (2, True, False, 100.0)


def test_acknowledging_one_leaves_the_others() -> None:
    alarms = ripen((), [condition(), condition(kind="battery"), condition("robot_1")], 1.0, 1.0)
    after = acknowledge(alarms, "robot_0", "obstacle")
    assert [alarm.acknowledged for alarm in after] == [True, False, False]
    assert acknowledge(alarms, "robot_7", "obstacle") == alarms
    assert all(alarm.acknowledged for alarm in acknowledge(alarms, "", ""))


def test_the_oldest_stands_first() -> None:
    alarms = ripen((), [condition("robot_1")], 1.0, 1.0)
    alarms = ripen(alarms, [condition("robot_0"), condition("robot_1")], 2.0, 2.0)
    assert [alarm.condition.source for alarm in alarms] == ["robot_1", "robot_0"]


@given(st.lists(st.sets(st.sampled_from(KINDS)), max_size=20))
def test_it_counts_how_often_its_condition_began(looks: list[set[tuple[str, str]]]) -> None:
    alarms: tuple[Alarm, ...] = ()
    began = dict.fromkeys(KINDS, 0)
    before: set[tuple[str, str]] = set()
    for n, holding in enumerate(looks):
        alarms = ripen(alarms, [condition(*key) for key in sorted(holding)], float(n), float(n))
        for key in holding - before:
            began[key] += 1
        before = holding
    assert {alarm.key: alarm.count for alarm in alarms} == {key: n for key, n in began.items() if n}


class Alarms(RuleBasedStateMachine):
    """Against a memory of its own: what holds, and what nobody has seen."""

    def __init__(self) -> None:
        super().__init__()
        self.alarms: tuple[Alarm, ...] = ()
        self.holding: set[tuple[str, str]] = set()
        self.unseen: set[tuple[str, str]] = set()
        self.at = 0.0

    @rule(holding=st.sets(st.sampled_from(KINDS)))
    def look(self, holding: set[tuple[str, str]]) -> None:
        self.at += 1.0
        self.alarms = ripen(self.alarms, [condition(*key) for key in sorted(holding)], self.at, self.at)
        self.unseen |= holding - self.holding
        self.holding = holding

    @rule(key=st.sampled_from(KINDS))
    def see(self, key: tuple[str, str]) -> None:
        self.alarms = acknowledge(self.alarms, *key)
        self.unseen.discard(key)

    @rule()
    def see_all(self) -> None:
        self.alarms = acknowledge(self.alarms, "", "")
        self.unseen.clear()

    @invariant()
    def nothing_is_lost_or_doubled(self) -> None:
        keys = [alarm.key for alarm in self.alarms]
        assert len(keys) == len(set(keys))
        assert set(keys) == self.holding | self.unseen
        assert {alarm.key for alarm in self.alarms if not alarm.acknowledged} == self.unseen
        assert {alarm.key for alarm in self.alarms if alarm.active} == self.holding


TestAlarms = Alarms.TestCase
