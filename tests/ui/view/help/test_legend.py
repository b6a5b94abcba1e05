"""The legend shows what the map and the tables show, in every drawing mode."""

import pytest

from fleet_tui.model.history.facts import Activity
from fleet_tui.ui.view.bars import BARS
from fleet_tui.ui.view.help.pages import legend
from fleet_tui.ui.view.help.section import search
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import SIGNS
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.fleets import R0, T0, fleet, reduced, text_of, tick
from tests.support.kinds import FULL, received


def signs(drawing: Drawing) -> dict[str, str]:
    """The sign of each meaning."""
    sections = legend(MapOptions(drawing=drawing))
    return {row.text: text_of(row.mark).strip() for section in sections for row in section.rows}


@pytest.mark.parametrize("drawing", list(Drawing))
def test_every_sign_has_a_picture(drawing: Drawing) -> None:
    blank = [meaning for meaning, sign in signs(drawing).items() if not sign]
    assert set(blank) <= {"free floor", "unknown ground", "the map cursor"}


def test_ascii_has_only_ascii_on_the_map() -> None:
    sections = legend(MapOptions(drawing=Drawing.ASCII))[:-1]
    assert all(text_of(row.mark).isascii() for section in sections for row in section.rows)


def test_states_differ_from_each_other() -> None:
    robots, *_ = legend(MapOptions())
    drawn = [row.mark for row in robots.rows]
    assert len(set(drawn)) == len(drawn)
    by_meaning = {str(row.text): row.mark for row in robots.rows}
    roles = {role for _, role in by_meaning["the selected robot"]}
    assert StyleRole.ROBOT_SELECTED in roles
    alarmed = by_meaning["! with an alarm, red until it is acknowledged"]
    assert StyleRole.ROBOT_ALARM in {role for _, role in alarmed}


def test_places_and_lines_are_those_of_the_map() -> None:
    found = signs(Drawing.BRAILLE)
    assert found["a docking station"] == "⌂ Dock" and found["an elevator"] == "↕ Lift"
    assert found["a one-way edge"] != found["an edge of the route graph"]
    assert found["the route of the selected robot's order"] != found["the route of its next orders"]


@pytest.mark.parametrize(("glyph", "meaning"), [("⌂", "docking"), ("▶", "cargo"), ("≈", "own map")])
def test_a_typed_glyph_is_explained(glyph: str, meaning: str) -> None:
    rows = [row.text for section in search(legend(MapOptions()), glyph) for row in section.rows]
    assert len(rows) == 1 and meaning in rows[0]


def test_each_word_for_what_a_robot_does_is_explained_with_its_sign_in_the_activity_pane() -> None:
    found = signs(Drawing.BRAILLE)
    assert {f"{BARS[does][0]} {does.value}" for does in Activity} <= set(found.values())
    assert "unknown" in found.values()


def test_the_ground_below_a_sign_is_no_sign_of_it() -> None:
    rows = [row for section in search(legend(MapOptions(drawing=Drawing.ASCII)), ".") for row in section.rows]
    assert rows == []


def test_the_tables_signs_are_those_of_the_tables() -> None:
    found = signs(Drawing.BRAILLE)
    assert {sign.strip() for sign in SIGNS.values()} <= set(found.values())
    online = text_of(fleet_table(received(FULL), R0, 60).rows[0].runs)
    offline = text_of(fleet_table(reduced(fleet(), tick(T0)), R0, 60).rows[0].runs)
    assert found["online; in the status line: the link is up"] in online
    assert found["offline, or no link"] in offline
