"""Facilities of sites."""

from fleet_tui.model.fleets.facility import DOOR, LIFT, Facility


def test_a_name_is_taken_once_for_each_link_and_sort() -> None:
    facilities = [
        Facility(LIFT, "a", 0.0, link="x"),
        Facility(DOOR, "a", 0.0, link="x"),
        Facility(LIFT, "a", 0.0, link="y"),
    ]
    assert len({one.key for one in facilities}) == 3
