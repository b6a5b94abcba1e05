"""Pictures of what robots did."""

from xml.etree.ElementTree import Element

from fleet_tui.features.history.report.axis import LocalTime
from fleet_tui.features.history.report.timeline import (
    HEIGHTS,
    HIGH,
    LEFT,
    WIDTH,
    legend,
    share_picture,
    timeline,
)
from fleet_tui.model.history.facts import Activity
from fleet_tui.records.history.division import Division

TIME = Division(0.0, 400.0, 4)


def clock(at: float, _is_long: bool) -> str:
    return f"{at:.0f}"


LOCAL = LocalTime(0.0, clock, clock)


def path(picture: Element, activity: Activity) -> str:
    (found,) = [one for one in picture.iter("path") if one.get("class") == activity.value]
    return str(found.get("d"))


def test_a_bar_lasts_as_long_as_its_activity_and_a_gap_has_none() -> None:
    rows = {"robot_0": [Activity.DRIVING, Activity.DRIVING, None, Activity.BLOCKED]}
    picture = timeline(rows, TIME, LOCAL)
    part = (WIDTH - LEFT) / 4
    assert path(picture, Activity.DRIVING) == f"M{LEFT:.1f},9h{2 * part:.1f}"
    assert path(picture, Activity.BLOCKED) == f"M{LEFT + 3 * part:.1f},9h{part:.1f}"
    assert [one.text for one in picture.iter("text")][-1] == "robot_0"


def test_shares_are_columns_from_below_and_above() -> None:
    picture = share_picture({"robot_0": [(0.5, 0.25), (0.0, 0.0), None, None]}, TIME, LOCAL)
    assert path(picture, Activity.DRIVING).endswith(f"v{-HIGH / 2:.1f}")
    assert path(picture, Activity.BLOCKED).endswith(f"v{HIGH / 4:.1f}")
    assert path(picture, Activity.IDLE).count("h") == 2


def test_each_activity_is_in_the_legend_and_two_of_a_height_differ_in_more_than_colour() -> None:
    assert [span[0].tail for span in legend()] == [activity.value for activity in Activity]
    assert len({height for activity, height in HEIGHTS.items() if activity is not Activity.OFFLINE}) == 7


def test_a_long_name_keeps_both_ends() -> None:
    name = "warehouse_north_robot_17"
    picture = timeline({name: [None] * 4}, TIME, LOCAL)
    assert [one.text for one in picture.iter("text")][-1] == "wareho…obot_17"
