"""Capabilities of navigating robots, derived from the names that a site has."""

import math

from fleet_tui.model import kind
from fleet_tui.robots.ros_navigation.kinds import BATTERY_SILENCE
from tests.support.nav2_adapter import adapter


def test_they_report_what_their_site_has_a_topic_for() -> None:
    assert {"odometry", "pose", "battery"} <= set(adapter().kind.reports)
    assert "battery" not in adapter(topics={"battery": ""}).kind.reports


def test_they_take_orders_to_places_and_keep_one_goal_at_a_time() -> None:
    its = adapter().kind
    assert all(its.can(asked) for asked in (kind.ORDER, kind.ORDER_TO, kind.CANCEL, kind.CLEAR))
    assert its.keeps_goals and its.takes_stops and its.reports_ends and not its.changes_floors


def test_a_value_is_old_after_its_own_time_which_the_profile_may_change() -> None:
    assert adapter().kind.silence["battery"] == BATTERY_SILENCE
    assert adapter(silence={"battery": 5.0}).kind.silence["battery"] == 5.0
    assert adapter(topics={"odometry": ""}).kind.silence["pose"] == math.inf
