"""The mode of a robot in words."""

from msgspec.structs import replace

from fleet_tui.model.robot import Reading
from fleet_tui.orders.mode import is_in_mode, mapping_text
from tests.support.fleets import R0, fleet

ROBOT = fleet().robots[R0]


def test_its_own_report_comes_before_our_switch() -> None:
    assert mapping_text(ROBOT) == ""
    ours = replace(ROBOT, mapping_by_us=True)
    assert mapping_text(ours) == "mapping (by us)"
    assert mapping_text(replace(ours, mode=Reading("navigation", 1.0))) == ""
    assert mapping_text(replace(ROBOT, mode=Reading("mapping", 1.0))) == "mapping"


def test_a_mode_counts_since_a_time() -> None:
    maps = replace(ROBOT, mode=Reading("mapping", 5.0))
    assert is_in_mode(maps, True, None) and is_in_mode(maps, True, 4.0)
    assert not is_in_mode(maps, True, 5.0) and not is_in_mode(maps, False, None)
    assert not is_in_mode(ROBOT, False, None)
