"""The area of the map that is looked at."""

from fleet_tui.model.attention import SeenArea


def test_an_area_has_its_edges() -> None:
    area = SeenArea(0.0, 10.0, 20.0, 30.0, 0.5)
    assert area.shows(0.0, 30.0) and area.shows(20.0, 10.0)
    assert not area.shows(-0.1, 20.0) and not area.shows(10.0, 30.1)
