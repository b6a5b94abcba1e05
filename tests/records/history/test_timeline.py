"""The activities of robots, part by part."""

from fleet_tui.model.history.facts import Activity
from fleet_tui.model.history.totals import ActivityTotal
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.timeline import main_activities, shares

TIME = Division(0.0, 300.0, 3)
TOTALS = [
    ActivityTotal("robot_0", 0, Activity.DRIVING, 60.0),
    ActivityTotal("robot_0", 0, Activity.BLOCKED, 40.0),
    ActivityTotal("robot_0", 1, Activity.IDLE, 20.0),
    ActivityTotal("robot_0", 1, Activity.OFFLINE, 20.0),
]


def test_each_part_has_what_took_longest_and_trouble_if_both_did() -> None:
    told = main_activities(["robot_0", "robot_1"], TIME, TOTALS)
    assert told == {"robot_0": [Activity.DRIVING, Activity.OFFLINE, None], "robot_1": [None, None, None]}


def test_shares_are_of_the_time_that_was_watched() -> None:
    told = shares(["robot_0", "robot_1"], TIME, TOTALS)
    assert told == {"robot_0": [(0.6, 0.4), (0.0, 0.5), None], "robot_1": [None, None, None]}
