"""A shift in figures."""

import pytest

from fleet_tui.model.history.facts import Activity, LinkChange
from fleet_tui.model.history.lives import AlarmLife
from fleet_tui.model.history.totals import ActivityTotal, ChargeTotal, OrderTotal
from fleet_tui.records.history.shift import causes_of, counted, outages_of, robots_of
from fleet_tui.text.language import Message

ORDERS = [
    OrderTotal("robot_10", "A -> B", "done", 5, 1, 4, 400.0, 200.0),
    OrderTotal("robot_2", "A -> B", "lost", 2, 0, 1, 9.0, 9.0),
    OrderTotal("robot_2", "A -> B", "failed", 1, 0, 0, 0.0, 0.0),
    OrderTotal("robot_2", "B -> A", "cancelled elsewhere", 3, 0, 0, 0.0, 0.0),
    OrderTotal("robot_2", "B -> A", "end not seen", 4, 0, 0, 0.0, 0.0),
]


def test_orders_by_robot_and_by_way() -> None:
    by_robot = counted(ORDERS, "robot")
    assert (by_robot["robot_10"].done, by_robot["robot_10"].late, by_robot["robot_10"].mean) == (5, 1, 100.0)
    two = by_robot["robot_2"]
    assert (two.done, two.lost, two.cancelled, two.unseen, two.mean) == (0, 3, 3, 4, None)
    assert counted(ORDERS, "way")["A -> B"].longest == 200.0


def test_robots_by_name_with_their_times_and_batteries() -> None:
    does = [
        ActivityTotal("robot_2", part, activity, 100.0)
        for part, activity in ((0, Activity.DRIVING), (1, Activity.BLOCKED), (1, Activity.OFFLINE))
    ]
    charges = [ChargeTotal("robot_2", 0, 20.0, 30.0), ChargeTotal("robot_2", 1, 25.0, 28.0)]
    two, ten = robots_of(ORDERS, does, charges)
    assert (two.name, two.down, two.watched, two.low, two.last) == ("robot_2", 200.0, 300.0, 20.0, 28.0)
    assert (ten.name, ten.down, ten.low, ten.last) == ("robot_10", 0.0, None, None)


def alarm(raised: float, returned: float | None, seen: float | None = None, source: str = "r") -> AlarmLife:
    return AlarmLife(source, Message("stuck"), "high", "stuck", raised, returned, seen, returned, "", 1)


def test_alarms_by_cause_count_only_the_time() -> None:
    battery = AlarmLife("r", Message("battery"), "medium", "low", 990.0, None, None, None, "", 3)
    lives = [alarm(50.0, 150.0, 60.0), alarm(200.0, 260.0, 230.0, "s"), battery]
    stuck, low = causes_of(lives, 100.0, 1000.0)
    assert (stuck.kind, stuck.count, stuck.sources, stuck.seconds, stuck.longest) == (
        "stuck",
        2,
        2,
        110.0,
        60.0,
    )
    assert stuck.until_seen == 20.0
    assert (low.count, low.seconds, low.until_seen) == (3, 10.0, None)


@pytest.mark.parametrize(
    ("changes", "count", "seconds"),
    [
        ([(0, True)], 0, 0.0),
        ([(50, False), (150, True), (300, False), (400, True)], 1, 150.0),
        ([(300, False), (310, False), (400, True)], 1, 100.0),
        ([(900, False)], 1, 100.0),
    ],
)
def test_outages_count_only_the_time(changes: list[tuple[int, bool]], count: int, seconds: float) -> None:
    links = [LinkChange("rosbridge", float(at), is_up) for at, is_up in changes]
    assert outages_of(links, 100.0, 1000.0) == {"rosbridge": (count, seconds)}
