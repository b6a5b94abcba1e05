"""A robot's battery as text and as a bar."""

import pytest

from fleet_tui.model.events import Event
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.fleet import battery_bar, battery_run
from fleet_tui.ui.view.tables.table import Run
from tests.support.fleets import R0, T0, battery, fleet, link_up, reduced, tick


def shown(*facts: Event, at: float = T0) -> tuple[Run, Run]:
    state = reduced(fleet(), link_up(T0), *facts, tick(at))
    robot = state.robots[R0]
    return battery_run(state, robot), battery_bar(state, robot)


@pytest.mark.parametrize(
    ("percent", "text", "bar", "role"),
    [
        (80.0, " 80 %", "━━━━┄", StyleRole.TEXT),
        (20.0, " 20 %", "━┄┄┄┄", StyleRole.TEXT),
        (19.9, " 19 %", "━┄┄┄┄", StyleRole.WARN),
        (8.0, "  8 %", "━┄┄┄┄", StyleRole.ALARM),
    ],
)
def test_only_a_low_battery_has_a_colour_and_only_a_critical_one_that_of_alarms(
    percent: float, text: str, bar: str, role: StyleRole
) -> None:
    is_low = role is not StyleRole.TEXT
    assert shown(battery(T0, percent)) == ((text, role), (bar, role if is_low else StyleRole.DIM))


def test_an_unknown_battery_and_one_of_an_offline_robot_are_quiet() -> None:
    assert shown() == (("  - %", StyleRole.DIM), ("", StyleRole.DIM))
    text, bar = shown(battery(T0, 5.0), at=T0 + 60)
    assert text == ("  5 %", StyleRole.DIM) and bar[1] is StyleRole.DIM
