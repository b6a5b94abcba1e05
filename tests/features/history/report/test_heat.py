"""Blocked places on a floor."""

from fleet_tui.features.history.report.heat import MARGIN, FloorHeat, around, heat
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.history.totals import BlockedPlace

PLACES = [
    BlockedPlace("f", 5.0, 5.0, 400.0),
    BlockedPlace("f", 5.1, 5.0, 300.0),
    BlockedPlace("f", 1.0, 9.0, 100.0),
]


def test_circles_are_where_the_map_has_the_places_and_their_area_is_the_time() -> None:
    frame = MapFrame(0.05, 200, 200, Pose(0.0, 0.0))
    figure = heat(FloorHeat("f", PLACES, frame, "data:image/png;base64,AA"))
    small, _, large = figure.iter("circle")
    assert (large.get("cx"), large.get("cy")) == ("100", "100")
    assert (small.get("cx"), small.get("cy")) == ("20", "20")
    assert float(str(large.get("r"))) == 2 * float(str(small.get("r")))
    assert [one.get("href") for one in figure.iter("image")] == ["data:image/png;base64,AA"]
    # Of two places side by side one is written: their texts would cover each other.
    assert [one.text for one in figure.iter("text")] == ["6 min", "100 s"]
    assert "".join(figure[-1].itertext()) == "f robots were blocked for 13 min in all"


def test_a_floor_without_a_map_has_room_around_its_places() -> None:
    frame = around(PLACES)
    for place in PLACES:
        column, row = frame.to_pixel(place.x, place.y)
        edge = MARGIN / frame.resolution * 0.99
        assert edge <= column <= frame.width - edge and edge <= row <= frame.height - edge
    assert around(PLACES[:1]).width == around(PLACES[:1]).height
