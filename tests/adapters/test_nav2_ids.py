"""Ids of goals on the wire: the one that stands for all of them is no goal's."""

import msgspec

from fleet_tui.adapters.adapter import Site
from fleet_tui.adapters.nav2.adapter import Nav2
from fleet_tui.adapters.nav2.goals import ALL
from fleet_tui.adapters.profile import Profile
from fleet_tui.model.navigation_events import GoalsReported

UUID = "Cii/ftYHQUKiCFVjZrbQVQ=="


def test_a_goal_of_zeros_is_never_known_for_to_cancel_it_would_cancel_all() -> None:
    adapter = Nav2(Profile(kind="nav2"), Site())
    feed = next(one for one in adapter.feeds("robot_0", ["hall"]) if one.key == "navigate_to_pose")
    stamp = {"sec": 1, "nanosec": 0}
    listed = [{"goal_info": {"goal_id": {"uuid": id_}, "stamp": stamp}, "status": 2} for id_ in (ALL, UUID)]
    (fact,) = adapter.read(feed, msgspec.Raw(msgspec.json.encode({"status_list": listed})), 5.0)
    assert isinstance(fact, GoalsReported)
    assert [goal.uuid for goal in fact.goals] == [UUID]
    assert fact.fault == "goal_id.uuid is all zeros, which means all goals"
