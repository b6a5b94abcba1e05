"""A robot's page: all sections at every width, the curve beside the state where it fits."""

from collections.abc import Sequence

import pytest
from msgspec.structs import replace

from fleet_tui.situation.battery.forecast import BatteryForecast
from fleet_tui.ui.view.robot.page import PageContent, page_lines, page_title
from fleet_tui.ui.view.robot.sections import Line
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import width_of
from tests.support.fleets import R0, T0, battery, fleet, link_up, pose, reduced, text_of, tick
from tests.support.kinds import BARE

STATE = reduced(fleet(2), link_up(T0), pose(T0), battery(T0), tick(T0 + 0.5))


def curve(width: int, height: int) -> Sequence[Line]:
    return [(("#" * width, StyleRole.ACCENT),)] * height


CONTENT = PageContent(STATE, STATE.robots[R0], lambda _wall: "14:20:00", curve, None)


def shown(content: PageContent, width: int = 80, height: int = 20) -> list[str]:
    lines = page_lines(content, width, height)
    assert all(width_of(line) == width for line in lines)
    return [text_of(line) for line in lines]


@pytest.mark.parametrize("width", [40, 73, 74, 80, 109, 110, 120, 200])
def test_every_section_is_there_at_every_width(width: int) -> None:
    text = "\n".join(shown(CONTENT, width))
    for title in ("State", "Battery", "Route", "Orders", "Alarms", "Commands"):
        assert f"─ {title} ─" in text
    assert "Battery   80 %" in text and "###" in text


@pytest.mark.parametrize(("width", "beside"), [(60, False), (80, True), (120, True)])
def test_the_curve_is_beside_the_state_where_it_fits(width: int, beside: bool) -> None:
    first = shown(CONTENT, width)[0]
    assert ("─ State ─" in first) and ("─ Battery ─" in first) is beside


def test_the_curve_grows_with_the_screen() -> None:
    heights = [sum("#" in line for line in shown(CONTENT, 120, height)) for height in (20, 36, 90)]
    assert heights == [8, 12, 18]


def test_the_guess_is_as_long_as_fits_and_said_to_be_one() -> None:
    guessed = replace(CONTENT, forecast=BatteryForecast(3 * 3600.0, 7200.0))
    assert "Battery a guess: low at 14:20, about 3 h left ─" in shown(guessed, 120)[0]
    assert "Battery maybe low at 14:20 ─" in shown(guessed, 80)[0].rstrip() + "─"
    is_low = replace(CONTENT, forecast=BatteryForecast(1200.0, None))
    assert "Battery a guess: about 20 min left ─" in shown(is_low, 120)[0]
    assert "Battery maybe 20 min left" in shown(is_low, 80)[0]
    assert "guess" not in "\n".join(shown(CONTENT, 120))


def test_without_a_level_the_reason_is_shown() -> None:
    unseen = replace(CONTENT, curve=lambda _width, _height: ())
    assert "none seen yet" in "\n".join(shown(unseen))
    bare = replace(CONTENT, robot=replace(CONTENT.robot, kind=BARE))
    assert "this kind of robot reports none" in "\n".join(shown(bare))
    loading = shown(replace(CONTENT, curve=None))
    assert "..." in loading[1] and "none seen" not in "\n".join(loading)


def test_the_title_counts_the_robots() -> None:
    assert text_of(page_title(STATE, "robot_1")) == " robot_1  oh_ressources on rosbridge, 2 of 2"
