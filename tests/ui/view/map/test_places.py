"""Places of the world in the view: many at once are where each is."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.places import pixels

FRAMES = st.builds(
    MapFrame,
    st.floats(0.01, 5.0),
    st.integers(1, 70),
    st.integers(1, 70),
    st.builds(Pose, st.floats(-50, 50), st.floats(-50, 50), st.floats(-7, 7)),
)


@given(FRAMES, st.lists(st.tuples(st.floats(-60, 60), st.floats(-60, 60)), min_size=1, max_size=9))
def test_many_places_at_once_are_where_each_is(frame: MapFrame, at: list[tuple[float, float]]) -> None:
    one_by_one = np.array([frame.to_pixel(*place) for place in at])
    assert np.allclose(pixels(frame, np.array(at)), one_by_one, atol=1e-6)
